#include "core/mapping/calibration/range_bias.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "core/cloud/filters/normals.h"
#include "core/cloud/filters/range_filter.h"
#include "core/cloud/filters/voxel_grid.h"
#include "tests/support/rooms.h"

namespace leitstand::test {
namespace {

/// What is matched of a turn at @p sensorInRoom, by a scanner whose ranges are @p tooLong [m].
PointCloud seen(const Pose& sensorInRoom, double tooLong, unsigned seed) {
    RoomSettings room;
    room.sensorInRoom = sensorInRoom;
    room.sweep = Sweep::Yawing;
    room.rows = 181;
    room.columns = 121;
    room.seed = seed;
    Scan scan = scanRoom(room).scan;
    for (Eigen::Vector3f& point : scan.points) point *= 1.0F + static_cast<float>(tooLong) / point.norm();
    PointCloud all = voxelGrid(pointsInRange(scan, {}, 0.4, 15.0), 0.07, VoxelPoint::Centroid);
    all.normals = knnNormals(all.points, 12);
    return all;
}

/// Of a drive of 1 m from scan to scan, each roughly where the one before says.
RangeBias driven(double tooLong, int scans) {
    RangeBias bias;
    const auto at = [](int i) {
        return poseFrom({-2.4 + 0.3 * i, 0.8 * std::sin(i), 0.9}, 0.0, 0.0, 0.4 * i);
    };
    for (int i = 3; i < scans; ++i) {
        const Pose off = poseFrom({0.01, -0.01, 0.005}, 0.0, degrees(0.1), degrees(-0.1));
        EXPECT_TRUE(bias.add(seen(at(i), tooLong, 2U * static_cast<unsigned>(i)),
                             seen(at(i - 3), tooLong, 2U * static_cast<unsigned>(i) + 1U),
                             at(i - 3).inverse() * at(i) * off));
    }
    return bias;
}

TEST(RangeBias, IsFoundFromScansOfOneRoomToAFewMillimetres) {
    for (const double tooLong : {0.05, 0.03, 0.0, -0.02}) {
        const auto found = driven(tooLong, 16).estimate();
        ASSERT_TRUE(found.has_value());
        EXPECT_NEAR(found->value, tooLong, 0.004) << tooLong;
        EXPECT_LT(found->deviation, 0.003) << tooLong;
    }
}

TEST(RangeBias, SaysNothingBeforeEnoughPairsOfScansDid) {
    EXPECT_EQ(RangeBias().estimate(), std::nullopt);
    const RangeBias few = driven(0.03, 8);
    EXPECT_EQ(few.pairs(), 5U);
    EXPECT_EQ(few.estimate(), std::nullopt);
}

TEST(RangeBias, AsksNothingOfScansThatCannotTell) {
    RangeBias bias;
    const PointCloud here = seen(poseFrom({0, 0, 0.9}, 0, 0, 0), 0.02, 1);
    EXPECT_FALSE(bias.add(here, here, Pose::Identity())) << "from one place all ranges are alike";
    EXPECT_FALSE(bias.add(here, here, poseFrom({100, 0, 0}, 0, 0, 0))) << "nothing meets";
    EXPECT_FALSE(bias.add({}, here, Pose::Identity()));
    EXPECT_FALSE(bias.add(here, {}, Pose::Identity()));
    PointCloud bare = here;
    bare.normals.clear();
    EXPECT_FALSE(bias.add(bare, here, Pose::Identity()));
    // One plane leaves all open.
    PointCloud plane;
    for (int i = 0; i < 2000; ++i) {
        plane.points.emplace_back(0.05F * static_cast<float>(i % 50), 0.05F * static_cast<float>(i / 50),
                                  -1.0F);
        plane.normals.emplace_back(0.0F, 0.0F, 1.0F);
    }
    EXPECT_FALSE(bias.add(plane, plane, poseFrom({1.0, 0, 0}, 0, 0, 0)));
    PointCloud broken = here;
    for (Eigen::Vector3f& normal : broken.normals)
        normal.setConstant(std::numeric_limits<float>::quiet_NaN());
    EXPECT_FALSE(bias.add(broken, here, poseFrom({1.0, 0, 0}, 0, 0, 0)));
    EXPECT_EQ(bias.pairs(), 0U);
}

}  // namespace
}  // namespace leitstand::test
