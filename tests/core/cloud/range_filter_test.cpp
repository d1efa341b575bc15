#include "core/cloud/filters/range_filter.h"

#include <limits>

#include <gtest/gtest.h>

namespace leitstand {
namespace {

constexpr float None = std::numeric_limits<float>::quiet_NaN();
constexpr float Huge = std::numeric_limits<float>::max();

TEST(RangeFilter, KeepsWhatIsInRangeWithItsLabelAndNormal) {
    Scan scan;
    scan.points = {{0.3F, 0, 0}, {0, 1, 0},       {None, None, None}, {0, 0, -2},
                   {40, 0, 0},   {1, Huge, Huge}, {None, 1, 0},       {0, 0, 0}};
    scan.labels = {Label::Wall,    Label::Wall, Label::Unlabelled, Label::Floor,
                   Label::Ceiling, Label::Wall, Label::Wall,       Label::Wall};
    std::vector<Eigen::Vector3f> normals(8, Eigen::Vector3f::UnitX());
    normals[3] = Eigen::Vector3f::UnitZ();

    const PointCloud cloud = pointsInRange(scan, normals, 0.4, 30.0);

    ASSERT_EQ(cloud.size(), 2U);
    EXPECT_EQ(cloud.points[0], Eigen::Vector3f(0, 1, 0));
    EXPECT_EQ(cloud.points[1], Eigen::Vector3f(0, 0, -2));
    EXPECT_EQ(cloud.labels, (std::vector{Label::Wall, Label::Floor}));
    EXPECT_EQ(cloud.normals[0], Eigen::Vector3f::UnitX());
    EXPECT_EQ(cloud.normals[1], Eigen::Vector3f::UnitZ());
}

TEST(RangeFilter, AddsNoLabelsOrNormalsOfItsOwn) {
    Scan scan;
    scan.points = {{1, 0, 0}};
    const PointCloud cloud = pointsInRange(scan, {}, 0.0, 10.0);
    EXPECT_EQ(cloud.size(), 1U);
    EXPECT_TRUE(cloud.normals.empty());
    EXPECT_TRUE(cloud.labels.empty());
    EXPECT_EQ(pointsInRange(Scan{}, {}, 0.0, 10.0).size(), 0U);
}

}  // namespace
}  // namespace leitstand
