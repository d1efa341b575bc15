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

TEST(BrakeFile, WhatTheWatchdogDoesComesBack) {
    const TemporaryFolder folder;
    const auto file = folder / "brakes.yaml";
    const BrakeResult late{.verdict = Verdict::Failed,
                           .seconds = 0.9,
                           .metres = 0.09,
                           .when = Time(1'700'000'000s),
                           .watchdog = BrakeResult::Watchdog::Stops,
                           .brakesAfter = 0.812};
    const BrakeResult none{.verdict = Verdict::Failed,
                           .seconds = 1.6,
                           .metres = 0.16,
                           .when = Time(1'700'000'100s),
                           .watchdog = BrakeResult::Watchdog::None};
    ASSERT_TRUE(writeBrakes(file, {{"late", late}, {"none", none}}).ok());
    const auto read = readBrakes(file);
    EXPECT_EQ(read.at("late"), late);
    EXPECT_EQ(read.at("none"), none);
    EXPECT_FALSE(read.at("late").showsNoWatchdog());
    EXPECT_TRUE(read.at("none").showsNoWatchdog());
}

TEST(BrakeFile, OfAFailureThatSaysNothingOfAWatchdogThereIsNone) {
    const TemporaryFolder folder;
    const auto file = folder / "brakes.yaml";
    const std::string failed = "brakes: {a: {verdict: failed, seconds: 0.9, metres: 0.1, when: 1";
    for (const char* rest :
         {"}}", ", stops: perhaps}}", ", stops: true}}", ", stops: true, brakes_after: .nan}}",
          ", stops: true, brakes_after: x}}", ", stops: false}}"}) {
        std::ofstream(file) << failed << rest;
        const auto read = readBrakes(file);
        ASSERT_TRUE(read.contains("a")) << rest;
        EXPECT_TRUE(read.at("a").showsNoWatchdog()) << rest;
    }
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
