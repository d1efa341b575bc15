#include "tests/support/rooms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

/// How far @p point is from the walls, floor and ceiling of an empty room [m].
double distanceFromEmptyRoom(const RoomSettings& room, const Eigen::Vector3d& point) {
    return std::min({std::abs(room.length / 2 - std::abs(point.x())),
                     std::abs(room.width / 2 - std::abs(point.y())), std::abs(point.z()),
                     std::abs(room.height - point.z())});
}

TEST(Rooms, AnEmptyRoomIsMeasuredAsTheBoxItIs) {
    for (const Sweep sweep : {Sweep::Tilting, Sweep::Yawing}) {
        RoomSettings settings;
        settings.furnished = false;
        settings.rangeNoise = 0.0;
        settings.sweep = sweep;
        settings.sensorInRoom = poseFrom({0.5, -0.7, 1.1}, degrees(10), degrees(-5), degrees(30));
        const RoomScan room = scanRoom(settings);
        ASSERT_EQ(room.scan.points.size(), 226U * 360U);
        for (const auto& point : room.scan.points) {
            ASSERT_LT(distanceFromEmptyRoom(settings, settings.sensorInRoom * point.cast<double>()), 1e-5);
        }
    }
}

TEST(Rooms, AllKindsOfSurfacesAreSeenAndTheNoiseIsAsAsked) {
    RoomSettings settings;
    const RoomScan noisy = scanRoom(settings);
    settings.rangeNoise = 0.0;
    const RoomScan exact = scanRoom(settings);
    std::array<std::size_t, LabelCount> counts{};
    double squares = 0.0;
    for (std::size_t i = 0; i < noisy.scan.points.size(); ++i) {
        ++counts[static_cast<std::size_t>(exact.trueLabels[i])];
        squares += (noisy.scan.points[i] - exact.scan.points[i]).cast<double>().squaredNorm();
    }
    EXPECT_EQ(counts[0], 0U);
    for (std::size_t label = 1; label < LabelCount; ++label) EXPECT_GT(counts[label], 5000U);
    EXPECT_NEAR(std::sqrt(squares / static_cast<double>(noisy.scan.points.size())), 0.01, 2e-4);
}

TEST(Rooms, ACorridorHasNoEchoFromItsEnds) {
    RoomSettings settings;
    settings.length = 20.0;
    settings.rangeNoise = 0.0;
    const RoomScan corridor = scanCorridor(settings);
    std::size_t silent = 0;
    for (std::size_t i = 0; i < corridor.scan.points.size(); ++i) {
        if (corridor.scan.points[i].allFinite()) {
            EXPECT_LE(std::abs(corridor.scan.points[i].y()), 1.0F + 1e-5F);
            EXPECT_LE(corridor.scan.points[i].x(), 10.0F + 1e-5F);
        } else {
            ++silent;
            EXPECT_EQ(corridor.trueLabels[i], Label::Unlabelled);
        }
    }
    EXPECT_GT(silent, 100U);
    EXPECT_LT(silent, corridor.scan.points.size() / 10);
}

TEST(Rooms, ACloudCoversTheRoomAndMovesWithAPose) {
    const PointCloud cloud = roomCloud(5'000, 1);
    ASSERT_EQ(cloud.size(), 5'000U);
    const Pose pose = poseFrom({1, 2, 3}, 0.1, 0.2, 0.3);
    const PointCloud there = moved(pose, cloud), back = moved(pose.inverse(), there);
    for (std::size_t i = 0; i < cloud.size(); ++i) {
        EXPECT_LE(std::abs(cloud.points[i].x()), 4.0F);
        EXPECT_FLOAT_EQ(cloud.normals[i].norm(), 1.0F);
        EXPECT_LT((back.points[i] - cloud.points[i]).norm(), 1e-5F);
        EXPECT_LT((back.normals[i] - cloud.normals[i]).norm(), 1e-5F);
    }
}

}  // namespace
}  // namespace leitstand::test
