#include "core/mapping/placement/laser_robot.h"

#include <chrono>
#include <memory>

#include <gtest/gtest.h>

#include "tests/core/mapping/live/slices.h"
#include "tests/core/mapping/placement/flat_world.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// A robot that starts beside another one in the nook, and is not in the map yet.
struct Beside {
    FlatWorld world = FlatWorld::nook();
    Pose slot = FlatWorld::at(0.1, -0.4, degrees(20));
    RobotTracker tracker{"crawler"};
    LaserRobot robot{tracker, "station"};
    LiveMapPtr map;
    Time now{10'000s};

    Beside() {
        LiveKeyScan scan;
        scan.id = 1;
        scan.reduced = std::make_shared<const MatchedCloud>(world.map().cloud);
        auto live = std::make_shared<LiveMap>();
        live->scans.push_back(scan);
        map = live;
    }
    /// Half a second of odometry, from @p begin to @p end.
    void drive(const Pose& begin, const Pose& end) {
        for (int i = 1; i <= 10; ++i) {
            now += 50ms;
            tracker.add(odometryAt(now, interpolated(begin, end, 0.1 * i)), now);
        }
    }
    void see(const FlatWorld& seen, const Pose& baseInMap, const LiveMapPtr& in) {
        EXPECT_FALSE(robot.see(seen.view(baseInMap, now), in, now));
    }
    std::optional<RobotPlaceSample> place() {
        return robot.placeBeside(slot * PlacementSettings{}.slotInOther.inverse(), map, now);
    }
};

TEST(LaserRobot, IsLookedForOnAfterItsClockWasSetBack) {
    Beside beside;
    const FlatWorld elsewhere({{{-3, -3}, {3, -2}}, {{3, -2}, {2.5, 3}}, {{2.5, 3}, {-3, -3}}});
    beside.drive(Pose::Identity(), Pose::Identity());
    beside.see(elsewhere, beside.slot, beside.map);
    EXPECT_FALSE(beside.place());
    beside.now -= 3600s;
    beside.drive(Pose::Identity(), Pose::Identity());
    beside.see(beside.world, beside.slot, beside.map);
    const auto found = beside.place();
    ASSERT_TRUE(found && found->certain);
    EXPECT_LT(distanceBetween(found->baseInMap, beside.slot), 0.04);
}

TEST(LaserRobot, WhatItDroveBeforeItsOdometryBeganAnewCountsToo) {
    Beside beside;
    const Pose begin = poseFrom({10, 3, 0}, 0, 0, 0), way = poseFrom({0.7, 0, 0}, 0, 0, 0);
    beside.drive(begin, begin);
    beside.see(beside.world, beside.slot, nullptr);  // there is no map yet
    beside.drive(begin, begin * way);
    const Pose there = beside.slot * way;
    beside.see(beside.world, there, nullptr);
    beside.drive(Pose::Identity(), Pose::Identity());
    beside.see(beside.world, there, beside.map);
    const auto found = beside.place();
    ASSERT_TRUE(found && found->certain);
    EXPECT_LT(distanceBetween(found->baseInMap, there), 0.04);
}

}  // namespace
}  // namespace leitstand::test
