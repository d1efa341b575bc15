#include "core/cloud/filters/outliers.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using test::RoomScan;
using test::RoomSettings;
using test::scanRoom;

/// A furnished room scanned with beams that split at edges.
struct SplitScan {
    Scan scan;
    std::vector<bool> mixed;  ///< hanging at least 10 cm before the background and behind the foreground
};

/// Lets half of the beams beside a depth jump of more than 30 cm return a range in between.
SplitScan withSplitBeams(const RoomScan& room, unsigned seed) {
    SplitScan result{room.scan, std::vector<bool>(room.scan.points.size())};
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    const auto columns = static_cast<std::size_t>(room.scan.columns);
    for (std::size_t i = 0; i + columns < room.scan.points.size(); ++i) {
        for (const std::size_t beside : {i + 1, i + columns}) {
            if (beside % columns == 0) continue;  // in the next row
            const float a = room.scan.points[i].norm(), b = room.scan.points[beside].norm();
            if (!(std::abs(a - b) > 0.3F) || unit(random) < 0.5F) continue;
            const float range = a + unit(random) * (b - a);
            result.scan.points[i] = room.scan.points[i] * (range / a);
            result.mixed[i] = std::abs(range - a) > 0.1F && std::abs(range - b) > 0.1F;
        }
    }
    return result;
}

class OutliersOfRooms : public testing::TestWithParam<Sweep> {};

TEST_P(OutliersOfRooms, MostMixedPixelsAreToldAndHardlyARealPoint) {
    RoomSettings settings;
    settings.sweep = GetParam();
    settings.sensorInRoom = poseFrom({0.2, 0.1, 1.0}, degrees(4), degrees(-3), degrees(20));
    const RoomScan room = scanRoom(settings);
    const SplitScan split = withSplitBeams(room, 7);
    const std::vector<bool> found = mixedPixels(split.scan);
    int mixed = 0, reported = 0, real = 0, lost = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (split.mixed[i]) {
            ++mixed;
            reported += found[i] ? 1 : 0;
        } else if (split.scan.points[i] == room.scan.points[i]) {
            ++real;
            lost += found[i] ? 1 : 0;
        }
    }
    std::printf("mixed pixels: %d of %d told, %d of %d real points lost\n", reported, mixed, lost, real);
    EXPECT_GT(mixed, 200);
    EXPECT_GT(reported, mixed * 80 / 100);
    EXPECT_LT(lost, real / 250);
}

TEST_P(OutliersOfRooms, ARoomWithoutSplitBeamsLosesNothingToSpeakOf) {
    RoomSettings settings;
    settings.sweep = GetParam();
    const RoomScan room = scanRoom(settings);
    const Scan cleaned = withoutMixedPixels(room.scan);
    std::size_t lost = 0;
    for (const auto& point : cleaned.points) lost += point.hasNaN() ? 1 : 0;
    std::printf("clean room: %zu of %zu points lost\n", lost, cleaned.points.size());
    EXPECT_LT(lost, cleaned.points.size() / 250);
}

TEST_P(OutliersOfRooms, IsolatedPointsGoAndTheRoomStays) {
    RoomSettings settings;
    settings.sweep = GetParam();
    const RoomScan room = scanRoom(settings);
    PointCloud cloud;
    cloud.points = room.scan.points;
    cloud.normals.resize(cloud.size(), Eigen::Vector3f::UnitZ());
    cloud.labels = room.trueLabels;
    cloud.weights.resize(cloud.size(), 2.0F);
    // Dust in the air, at least 0.5 m from everything else.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> place(-0.5F, 0.5F);
    const std::size_t dust = 40, walls = cloud.size();
    for (std::size_t i = 0; i < dust; ++i) {
        cloud.points.push_back({2 * place(random), 2 * place(random), place(random)});
        cloud.normals.push_back(Eigen::Vector3f::UnitX());
        cloud.labels.push_back(Label::Unlabelled);
        cloud.weights.push_back(1.0F);
    }
    const PointCloud cleaned = withoutIsolated(cloud);
    ASSERT_EQ(cleaned.normals.size(), cleaned.size());
    ASSERT_EQ(cleaned.labels.size(), cleaned.size());
    ASSERT_EQ(cleaned.weights.size(), cleaned.size());
    std::size_t left = 0;
    for (const Label label : cleaned.labels) left += label == Label::Unlabelled ? 1 : 0;
    std::printf("isolated: %zu of %zu left, %zu of %zu real points lost\n", left, dust,
                walls - (cleaned.size() - left), walls);
    EXPECT_LE(left, 4U);
    EXPECT_LT(walls - (cleaned.size() - left), walls / 200);
}

INSTANTIATE_TEST_SUITE_P(Sweeps, OutliersOfRooms, testing::Values(Sweep::Tilting, Sweep::Yawing),
                         [](const auto& sweep) {
                             return sweep.param == Sweep::Tilting ? "Tilting" : "Yawing";
                         });

/// A raw scan of these ranges [m], half a degree from beam to beam.
Scan rawScan(const std::vector<float>& ranges) {
    Scan scan;
    scan.rows = 1;
    scan.columns = static_cast<int>(ranges.size());
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        const float angle = static_cast<float>(degrees(0.5)) * static_cast<float>(i);
        scan.points.push_back(ranges[i] * Eigen::Vector3f(std::cos(angle), std::sin(angle), 0.0F));
    }
    return scan;
}

std::vector<bool> mixedOf(const std::vector<float>& ranges) {
    return mixedPixels(rawScan(ranges));
}

TEST(MixedPixels, HangBetweenForegroundAndBackground) {
    EXPECT_EQ(mixedOf({2, 2, 2.6F, 4, 4}), (std::vector{false, false, true, false, false}));
    EXPECT_EQ(mixedOf({4, 4, 3.4F, 2.5F, 2, 2}), (std::vector{false, false, true, true, false, false}));
}

TEST(MixedPixels, AreNoPartOfJumpsPolesAndGrazedWalls) {
    EXPECT_EQ(mixedOf({2, 2, 4, 4}), std::vector<bool>(4));                       // a clean edge
    EXPECT_EQ(mixedOf({4, 4, 2, 4, 4}), std::vector<bool>(5));                    // a pole one beam wide
    EXPECT_EQ(mixedOf({3, 3.3F, 3.7F, 4.2F, 4.9F, 5.8F}), std::vector<bool>(6));  // along a wall
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(mixedOf({2, 2, nan, 4, nan}), std::vector<bool>(5));
    EXPECT_TRUE(mixedPixels(Scan()).empty());
}

TEST(MixedPixels, BecomeNoEchoAndTheGridStays) {
    const Scan scan = rawScan({2, 2, 2.6F, 4, 4});
    const Scan cleaned = withoutMixedPixels(scan);
    ASSERT_EQ(cleaned.points.size(), scan.points.size());
    EXPECT_EQ(cleaned.columns, scan.columns);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        EXPECT_EQ(cleaned.points[i].hasNaN(), i == 2);
    }
}

TEST(Isolated, SparsePointsFarAwayAreNoOutliers) {
    PointCloud cloud;  // 0.5 degrees apart at 20 m: 17 cm
    for (int y = -10; y <= 10; ++y) {
        for (int z = -10; z <= 10; ++z) {
            cloud.points.push_back({20.0F, 0.17F * static_cast<float>(y), 0.17F * static_cast<float>(z)});
        }
    }
    EXPECT_EQ(withoutIsolated(cloud).size(), cloud.size());
}

TEST(Isolated, SmallCloudsAreAllIsolated) {
    PointCloud two;
    EXPECT_EQ(withoutIsolated(two).size(), 0U);
    two.points = {{1, 0, 0}, {1, 0, 0}};
    EXPECT_EQ(withoutIsolated(two).size(), 0U);
    EXPECT_EQ(withoutIsolated(two, {.leastNeighbours = 1}).size(), 2U);
}

}  // namespace
}  // namespace leitstand
