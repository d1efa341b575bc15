#include "widgets/map_view/scene/scene_sample.h"

#include <memory>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

/// A scan of @p count points a millimetre apart along x, seen from @p place, shown from the last on; the red
/// of its points is its @p number.
SceneScan scanOf(int count, std::uint8_t number, const Eigen::Vector3d& place) {
    const auto owner = std::make_shared<Scan>();
    std::vector<std::uint32_t> order;
    for (int i = 0; i < count; ++i) {
        owner->points.emplace_back(0.001F * static_cast<float>(i), 0.0F, 0.0F);
        owner->labels.push_back(Label::Wall);
        order.push_back(static_cast<std::uint32_t>(count - 1 - i));
    }
    const auto points = std::make_shared<ScanPoints>();
    points->points = owner->points;
    points->labels = owner->labels;
    points->order = std::make_shared<const PointOrder>(order);
    points->owner = owner;
    PointPaint paint;
    paint.colouring = MapColouring::Scan;
    paint.one = {number, 0, 0, 255};
    SceneScan scan;
    scan.poseInMap = Pose(Eigen::Translation3d(place));
    scan.points = points;
    scan.look = lookOf(*points, paint, true, false);
    return scan;
}

std::size_t countOf(const SceneSample& sample, std::uint8_t number, std::size_t among) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < among; ++i) count += sample.points->colours.at(i).r == number ? 1 : 0;
    return count;
}

TEST(SceneSampleTest, HasTheFirstOfEachScanAtTheirPlaces) {
    const std::vector<SceneScan> scans = {scanOf(1'000, 1, {0, 5, 0}), scanOf(500, 2, {0, -5, 1})};
    const SceneSample sample = sampleOf(scans, 300);
    EXPECT_DOUBLE_EQ(sample.share, 0.2);
    ASSERT_EQ(sample.points->size(), 300U);
    EXPECT_EQ(countOf(sample, 1, 300), 200U);
    EXPECT_EQ(countOf(sample, 2, 300), 100U);
    EXPECT_TRUE(sample.points->points[0].isApprox(Eigen::Vector3f(0.999F, 5, 0))) << "shown first";
    for (std::size_t i = 0; i < 300; ++i) {
        const Eigen::Vector3f& point = sample.points->points[i];
        const bool first = sample.points->colours[i].r == 1;
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
    EXPECT_EQ(sample.points->size(), 47U);
    EXPECT_EQ(sample.points->colours.size(), 47U);
}

TEST(SceneSampleTest, OfAnUncertainScanBelowACeilingOnlyTheThirdThatIsNoCeilingIsDrawn) {
    SceneScan scan = scanOf(30, 1, {0, 0, 0});
    const auto ceiling = std::make_shared<Scan>(*scan.points->owner);
    for (std::size_t i = 0; i < ceiling->labels.size(); i += 2) ceiling->labels[i] = Label::Ceiling;
    auto points = std::make_shared<ScanPoints>(*scan.points);
    points->labels = ceiling->labels;
    points->labelCounts[static_cast<std::size_t>(Label::Ceiling)] = 15;
    const PointPaint paint;
    scan.points = points;
    scan.look = lookOf(*points, paint, false, false);
    EXPECT_EQ(sampleOf({scan}, 300).points->size(), 15U);
    scan.look = lookOf(*points, paint, true, true);
    EXPECT_EQ(sampleOf({scan}, 300).points->size(), 10U);
    scan.look = lookOf(*points, paint, false, true);
    const SceneSample sample = sampleOf({scan}, 300);
    ASSERT_EQ(sample.points->size(), 5U) << "of the first ten, 29 to 20, those with odd places";
    EXPECT_FLOAT_EQ(sample.points->points.back().x(), 0.021F);
    EXPECT_EQ(scan.look->shown, 5U);
}

TEST(SceneSampleTest, HiddenAndUnfinishedScansAreLeftOut) {
    std::vector<SceneScan> scans = {scanOf(10, 1, {0, 0, 0}), scanOf(10, 2, {0, 0, 0}),
                                    scanOf(0, 3, {0, 0, 0}), SceneScan{}};
    scans[0].visible = false;
    const SceneSample sample = sampleOf(scans, 300);
    EXPECT_EQ(sample.points->size(), 10U);
    EXPECT_EQ(countOf(sample, 2, 10), 10U);
    EXPECT_TRUE(sampleOf({}, 300).points->points.empty());
}

}  // namespace
}  // namespace leitstand
