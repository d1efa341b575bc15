#include "widgets/map_view/scene/scene_sample.h"

#include <memory>
#include <numeric>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

/// A scan of @p count points a millimetre apart along x, seen from @p place, shown from the last on; the red
/// of its points is its @p number.
SceneScan scanOf(int count, std::uint8_t number, const Eigen::Vector3d& place) {
    const auto owner = std::make_shared<Scan>();
    const auto colours = std::make_shared<std::vector<Rgba>>();
    std::vector<std::uint32_t> shown;
    for (int i = 0; i < count; ++i) {
        owner->points.emplace_back(0.001F * static_cast<float>(i), 0.0F, 0.0F);
        colours->push_back({number, 0, 0, 255});
        shown.push_back(static_cast<std::uint32_t>(count - 1 - i));
    }
    const auto points = std::make_shared<ScanPoints>();
    points->points = owner->points;
    points->owner = owner;
    SceneScan scan;
    scan.poseInMap = Pose(Eigen::Translation3d(place));
    scan.points = points;
    scan.look = {colours, std::make_shared<const PointOrder>(shown)};
    return scan;
}

std::size_t countOf(const SceneSample& sample, std::uint8_t number, std::size_t among) {
    const auto& colours = *sample.scan.look.colours;
    std::size_t count = 0;
    for (std::size_t i = 0; i < among; ++i) count += colours.at(i).r == number ? 1 : 0;
    return count;
}

TEST(SceneSampleTest, HasTheFirstOfEachScanAtTheirPlaces) {
    const std::vector<SceneScan> scans = {scanOf(1'000, 1, {0, 5, 0}), scanOf(500, 2, {0, -5, 1})};
    const SceneSample sample = sampleOf(scans, 300);
    EXPECT_DOUBLE_EQ(sample.share, 0.2);
    ASSERT_EQ(sample.scan.points->points.size(), 300U);
    EXPECT_EQ(countOf(sample, 1, 300), 200U);
    EXPECT_EQ(countOf(sample, 2, 300), 100U);
    EXPECT_TRUE(sample.scan.poseInMap.isApprox(Pose::Identity()));
    EXPECT_TRUE(sample.scan.points->points[0].isApprox(Eigen::Vector3f(0.999F, 5, 0))) << "shown first";
    for (std::size_t i = 0; i < 300; ++i) {
        const std::size_t index = (*sample.scan.look.shown)[i];
        const Eigen::Vector3f& point = sample.scan.points->points[index];
        const bool first = (*sample.scan.look.colours)[index].r == 1;
        EXPECT_FLOAT_EQ(point.y(), first ? 5.0F : -5.0F);
        EXPECT_GE(point.x(), first ? 0.7995F : 0.3995F) << "not the last of what its scan shows";
    }
}

TEST(SceneSampleTest, EveryBeginningIsFair) {
    const std::vector<SceneScan> scans = {scanOf(10'000, 1, {0, 0, 0}), scanOf(10'000, 2, {0, 0, 0})};
    const SceneSample sample = sampleOf(scans, 5'000);
    for (const std::size_t among : {100U, 1'000U, 4'000U})
        EXPECT_NEAR(static_cast<double>(countOf(sample, 1, among)), 0.5 * static_cast<double>(among), 8.0);
}

TEST(SceneSampleTest, OfFewPointsHasAll) {
    const SceneSample sample = sampleOf({scanOf(10, 1, {0, 0, 0}), scanOf(37, 2, {0, 0, 0})}, 300);
    EXPECT_DOUBLE_EQ(sample.share, 1.0);
    EXPECT_EQ(sample.scan.points->points.size(), 47U);
    EXPECT_EQ(sample.scan.look.shown->size(), 47U);
}

TEST(SceneSampleTest, HiddenAndUnfinishedScansAreLeftOut) {
    std::vector<SceneScan> scans = {scanOf(10, 1, {0, 0, 0}), scanOf(10, 2, {0, 0, 0}),
                                    scanOf(0, 3, {0, 0, 0}), SceneScan{}};
    scans[0].visible = false;
    const SceneSample sample = sampleOf(scans, 300);
    EXPECT_EQ(sample.scan.points->points.size(), 10U);
    EXPECT_EQ(countOf(sample, 2, 10), 10U);
    EXPECT_TRUE(sampleOf({}, 300).scan.points->points.empty());
}

}  // namespace
}  // namespace leitstand
