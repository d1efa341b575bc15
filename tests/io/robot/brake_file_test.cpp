#include "core/io/robot/brake_file.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Verdict = BrakeResult::Verdict;

TEST(BrakeFile, WhatIsKnownComesBackAndWhatIsNotIsLeftOut) {
    const TemporaryFolder folder;
    const auto file = folder / "brakes.yaml";
    const BrakeResult passed{
        .verdict = Verdict::Passed, .seconds = 0.312, .metres = 0.021, .when = Time(1'700'000'000s)};
    const BrakeResult failed{
        .verdict = Verdict::Failed, .seconds = 1.6, .metres = 0.16, .when = Time(1'700'000'100s)};
    const BrakeResult unclear{.verdict = Verdict::Inconclusive, .cause = BrakeResult::Cause::KeyLetGo};
    ASSERT_TRUE(writeBrakes(file, {{"kurt3d", passed}, {"rover", failed}, {"other", unclear}}).ok());
    const auto read = readBrakes(file);
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read.at("kurt3d"), passed);
    EXPECT_EQ(read.at("rover").verdict, Verdict::Failed);
}

TEST(BrakeFile, NonsenseIsNoTest) {
    const TemporaryFolder folder;
    const auto file = folder / "brakes.yaml";
    EXPECT_TRUE(readBrakes(file).empty());
    for (const char* text :
         {"", "a: 1", "brakes: {a: {verdict: passed, seconds: 1, metres: 0, when: 9223372036854775807}}",
          "brakes: {a: {verdict: passed, seconds: -1, metres: 0, when: 1}}", "brakes", "brakes: 3",
          "brakes: {a: 1}", "brakes: {a: {verdict: passed}}", "{{{",
          "brakes: {a: {verdict: passed, seconds: .nan, metres: 0, when: 1}}",
          "brakes: {a: {verdict: perhaps, seconds: 1, metres: 0, when: 1}}"}) {
        std::ofstream(file) << text;
        EXPECT_TRUE(readBrakes(file).empty()) << text;
    }
    std::ofstream(file) << "brakes: {a: 1, b: {verdict: failed}, c: {verdict: passed}}";
    ASSERT_EQ(readBrakes(file).size(), 1u);
    EXPECT_EQ(readBrakes(file).at("b").verdict, Verdict::Failed)
        << "a damaged file lets no robot drive that failed";
    EXPECT_FALSE(writeBrakes(folder / "no" / "such" / "folder.yaml", {}).ok());
}

}  // namespace
}  // namespace leitstand::test
