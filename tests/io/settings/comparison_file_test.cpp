#include "core/io/settings/comparison_file.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

MapComparison sample() {
    MapComparison whole;
    whole.settings.minimizer = Minimizer::DualQuaternion;
    whole.settings.reference = Reference::Map;
    whole.settings.reduce = 0.05;
    whole.settings.maxDistances = {1.5, 0.5};
    whole.rejected = 2;
    for (int i = 1; i <= 3; ++i) {
        ComparedScan one;
        one.id = static_cast<std::uint64_t>(i);
        one.recorded = poseFrom({1.0 * i, -0.5, 0.1}, 0.01, 0.02, 3.0);
        one.again = poseFrom({1.1 * i, -0.5, 0.1}, 0.01, 0.02, -3.0);
        one.uncertainAgain = i == 2;
        if (i > 1) one.fitRecorded = one.fitAgain = ScanFit{0.0123, 0.81};
        whole.scans.push_back(one);
    }
    whole.again.seconds = 1.25;
    whole.recorded.truth = TrajectoryError{.poses = 3, .position = 0.031, .rotation = 0.01};
    whole.again.finds = FindsError{.finds = 2, .mean = 0.2, .worst = 0.3, .missed = 4, .wrong = 1};
    sumUp(whole);
    return whole;
}

std::string errorOf(const std::string& text) {
    const auto read = parseComparison(text, "comparison.yaml");
    return read ? std::string() : read.error().text;
}

std::string without(const std::string& text, const std::string& part, const std::string& by = {}) {
    const auto at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part;
    if (at == std::string::npos) return text;
    std::string changed = text.substr(0, at);
    changed.append(by);
    changed.append(text.substr(at + part.size()));
    return changed;
}

TEST(ComparisonFile, ComesBackAsItWasWritten) {
    const TemporaryFolder folder;
    const MapComparison before = sample();
    ASSERT_TRUE(saveComparison(before, folder / "comparison.yaml"));
    const auto after = readComparison(folder / "comparison.yaml");
    ASSERT_TRUE(after) << after.error().text;
    EXPECT_EQ(writeComparison(*after), writeComparison(before));
    EXPECT_EQ(after->settings.minimizer, Minimizer::DualQuaternion);
    EXPECT_EQ(after->settings.reference, Reference::Map);
    EXPECT_EQ(after->settings.maxDistances, before.settings.maxDistances);
    EXPECT_TRUE(after->scans[2].again.isApprox(before.scans[2].again, 1e-8));
    EXPECT_TRUE(after->scans[1].uncertainAgain);
    EXPECT_FALSE(after->scans[0].fitAgain);
    EXPECT_EQ(after->again.uncertain, 1);
    EXPECT_NEAR(after->mostMoved, before.mostMoved, 1e-8);
    EXPECT_EQ(after->again.seconds, 1.25);
    EXPECT_EQ(after->recorded.truth.value().poses, 3);
    EXPECT_EQ(after->again.finds.value().worst, 0.3);
    EXPECT_EQ(after->again.finds.value().missed, 4);
    EXPECT_EQ(after->again.finds.value().found(), 1);
    EXPECT_FALSE(after->again.truth || after->recorded.finds);
    EXPECT_THAT(readComparison(folder / "none.yaml").error().text, HasSubstr("none.yaml: cannot be opened"));
}

TEST(ComparisonFile, ErrorsTellFileLineAndWhatWasExpected) {
    const std::string good = writeComparison(sample());
    EXPECT_EQ(errorOf(good), "");
    EXPECT_THAT(errorOf("reduce: 0.1\n"), HasSubstr("comparison.yaml:1: scans: expected a list"));
    EXPECT_THAT(errorOf(without(good, "dual-quaternion", "dual")), HasSubstr("comparison.yaml:2: minimizer"));
    EXPECT_THAT(errorOf(without(good, "{id: 2", "{id: 1")), HasSubstr("already"));
    EXPECT_THAT(errorOf(without(good, "{id: 2", "{id: 0")), HasSubstr("id"));
    EXPECT_THAT(errorOf(without(good, "{id: 2, ", "{")), HasSubstr("is missing"));
    EXPECT_THAT(errorOf(without(good, "[2, -0.5", "[.nan, -0.5")), HasSubstr("scans[1].recorded"));
    EXPECT_THAT(errorOf(without(good, "[2, -0.5, 0.1", "[2, -0.5, 0.1, 7")), HasSubstr("scans[1].recorded"));
    EXPECT_THAT(errorOf(without(good, "[1.5, 0.5]", "[]")), HasSubstr("max_distances"));
    EXPECT_THAT(errorOf(without(good, "[1.5, 0.5]", "[-1]")), HasSubstr("max_distances"));
    EXPECT_THAT(errorOf(without(good, "[0.0123, 0.81]", "[0.0123, 1.81]")), HasSubstr("a share"));
    EXPECT_THAT(errorOf(without(good, "[3, 0.031", "[3, -1")), HasSubstr("truth"));
    EXPECT_THAT(errorOf(without(good, "seconds:", "second:")), HasSubstr("did you mean"));
    const std::size_t turn = good.find("again: [1.1");
    std::string longer = good;
    longer[longer.find(", ", longer.find("0.1, ", turn)) + 2] = '9';
    EXPECT_THAT(errorOf(longer), HasSubstr("quaternion"));
}

TEST(ComparisonFile, HostileFilesAreErrors) {
    const std::string good = writeComparison(sample());
    std::string deep = "scans: ";
    for (int i = 0; i < 5'000; ++i) deep += "[{a: ";
    EXPECT_FALSE(errorOf(deep).empty());
    EXPECT_FALSE(errorOf(std::string(1U << 20U, 'x')).empty());
    EXPECT_FALSE(errorOf("").empty());
    for (std::size_t length = 0; length < good.size(); length += 3)
        (void)parseComparison(std::string_view(good).substr(0, length), "cut.yaml");
    std::mt19937 random(7);
    for (int i = 0; i < 300; ++i) {
        std::string broken = good;
        for (int k = 0; k < 4; ++k) broken[random() % broken.size()] = static_cast<char>(random() % 256);
        (void)parseComparison(broken, "broken.yaml");
    }
    MapComparison huge = sample();
    huge.scans.resize(20'000);
    const TemporaryFolder folder;
    EXPECT_FALSE(saveComparison(huge, folder / "comparison.yaml"));
    EXPECT_FALSE(std::filesystem::exists(folder / "comparison.yaml"));
}

}  // namespace
}  // namespace leitstand::test
