#include "core/cloud/packed_cloud.h"

#include <random>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

PointCloud cloudOf(std::size_t count, float reach) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> along(-reach, reach), part(-1.0F, 1.0F);
    PointCloud cloud;
    for (std::size_t i = 0; i < count; ++i) {
        cloud.points.emplace_back(along(random), along(random), along(random));
        cloud.normals.push_back(i % 10 == 0 ? Eigen::Vector3f::Zero()
                                            : Eigen::Vector3f(part(random), part(random), part(random)));
        cloud.normals.back().normalize();  // leaves a zero as it is
        cloud.labels.push_back(i % 3 == 0 ? Label::Floor : Label::Wall);
    }
    return cloud;
}

TEST(PackedCloud, ComesBackWithinHalfAStepInAboutHalfTheMemory) {
    const PointCloud cloud = cloudOf(5'000, 15.0F);
    const PackedCloud packed(cloud);
    EXPECT_LE(packed.step(), 0.0005F);
    EXPECT_EQ(packed.memory(), 13 * cloud.size()) << "of 25 bytes each";
    const PointCloud back = packed.unpacked();
    ASSERT_EQ(back.size(), cloud.size());
    ASSERT_EQ(back.normals.size(), cloud.size());
    EXPECT_EQ(back.labels, cloud.labels);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        EXPECT_LE((back.points[i] - cloud.points[i]).cwiseAbs().maxCoeff(), 0.51F * packed.step());
        EXPECT_LE((back.normals[i] - cloud.normals[i]).norm(), 5e-5F);
        EXPECT_EQ(back.normals[i].isZero(), cloud.normals[i].isZero()) << "unknown stays unknown";
    }
}

TEST(PackedCloud, TheFarthestPointStaysWhereItIs) {
    PointCloud cloud = cloudOf(10, 2.0F);
    cloud.points.emplace_back(-80.0F, 0.0F, 79.9F);
    cloud.normals.clear();
    cloud.labels.clear();
    const PointCloud back = PackedCloud(cloud).unpacked();
    EXPECT_NEAR(back.points.back().x(), -80.0F, 1e-4F);
    EXPECT_NEAR(back.points.back().z(), 79.9F, 2e-3F);
    EXPECT_TRUE(back.normals.empty() && back.labels.empty());
}

TEST(PackedCloud, OfNothingOrOfTheOriginAlone) {
    EXPECT_EQ(PackedCloud(PointCloud{}).unpacked().size(), 0U);
    PointCloud origin;
    origin.points.push_back(Eigen::Vector3f::Zero());
    EXPECT_TRUE(PackedCloud(origin).unpacked().points.front().isZero());
}

}  // namespace
}  // namespace leitstand::test
