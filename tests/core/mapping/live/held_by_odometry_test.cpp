#include <algorithm>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/mapping/live/scan_doubts.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Field;

/// Where a second room lies to the first one, farther off than anything is seen.
const Pose Beyond = poseFrom({14, 3, 0}, 0, 0, degrees(70));

/// What a robot in the second room sees, and where odometry has it there, off by @p off.
LiveScan beyond(const Pose& sensorInRoom, unsigned seed, const Pose& off = Pose::Identity()) {
    LiveScan live = scanAt(sensorInRoom, seed);
    RoomSettings room;
    room.length = 4.6;
    room.width = 3.4;
    room.height = 3.3;
    room.furnished = false;
    room.sensorInRoom = sensorInRoom;
    room.sweep = Sweep::Yawing;
    room.rows = 121;
    room.columns = 81;
    room.seed = seed;
    Scan scan = *live.scan;
    scan.points = scanRoom(room).scan.points;
    scan.sensorInOdom = off * Beyond * sensorInRoom;
    live.scan = std::make_shared<const Scan>(std::move(scan));
    return live;
}

LiveScan withoutPoints(const Pose& sensorInOdom, unsigned seed) {
    LiveScan live = scanAt(sensorInOdom, seed);
    auto scan = std::make_shared<Scan>(*live.scan);
    std::fill(scan->points.begin(), scan->points.end(), Eigen::Vector3f::Constant(0.01F));
    live.scan = std::move(scan);
    return live;
}

Pose along(int step) {
    return poseFrom({-1.4 + 0.4 * step, 0.05 * step, 0.9}, 0, 0, degrees(3) * step);
}

/// Where odometry would have to stand in the map for that to be right.
double offOf(const MapUpdate& update, const LiveScan& scan, const Pose& mapInRoom) {
    return distanceBetween(update.scanInMap, mapInRoom * scan.scan->sensorInOdom);
}

struct TwoRooms : MappedRoom {
    explicit TwoRooms(LiveSettings settings = {}) : MappedRoom(std::move(settings)) {
        drive(4);
        const LiveMapPtr map = mapper.map();
        mapInOdom = map->scans.back().pose.scanInMap * map->scans.back().scan->sensorInOdom.inverse();
    }
    Pose mapInOdom = Pose::Identity();
};

TEST(HeldByOdometry, ARoomBehindADarkCorridorIsMappedFromWhereOdometryHasIt) {
    TwoRooms rooms;
    // Smoke: nothing is seen for 10 m.
    for (int i = 0; i < 3; ++i)
        rooms.add(withoutPoints(poseFrom({3.0 + 3.0 * i, 0, 0.9}, 0, 0, 0), rooms.seed++));
    std::vector<MapUpdate> updates;
    for (int i = 0; i < 4; ++i) {
        const LiveScan scan = beyond(along(i), rooms.seed++);
        updates.push_back(rooms.add(scan));
        EXPECT_EQ(updates.back().localisation.trust, ScanTrust::Certain)
            << i << ": " << inWords(updates.back().localisation.doubts);
        EXPECT_LT(offOf(updates.back(), scan, rooms.mapInOdom), 0.05) << i;
        ASSERT_TRUE(updates.back().keyScan) << i;
        if (i == 0) {
            EXPECT_LT(rooms.mapper.fix("kurt3d")->certainty, 0.9) << "as sure as odometry is";
        }
    }
    const MapUpdate& first = updates.front();
    ASSERT_TRUE(first.links);
    EXPECT_THAT(first.links->links, ElementsAre(Field(&Link::kind, LinkKind::Odometry)))
        << "nothing else tells how the room lies to the other";
    EXPECT_EQ(first.links->links.front().from, 4U)
        << "not on what was seen in the smoke, which may be rejected";
    EXPECT_TRUE(has(first.poses->poses[0].doubts, ScanDoubt::Overlap)) << "the log says so";
    EXPECT_EQ(updates.back().keyScan->matched, updates[2].keyScan->id) << "what follows is built on it";
    EXPECT_TRUE(alike(rooms.poses(), rooms.log.poses()));
}

TEST(HeldByOdometry, WhatFillsTheRoomThatIsKnownIsNotBelieved) {
    TwoRooms rooms;
    // Carried into the other room: odometry has it in the first one still.
    LiveScan carried = beyond(poseFrom({1.0, -1.2, 0.9}, 0, 0, degrees(160)), rooms.seed++);
    auto scan = std::make_shared<Scan>(*carried.scan);
    scan->sensorInOdom = along(3);
    carried.scan = std::move(scan);
    EXPECT_EQ(rooms.add(carried).localisation.trust, ScanTrust::Uncertain);
    // Nor what comes after it, wherever odometry goes: that is not where the robot is.
    for (int i = 0; i < 3; ++i)
        EXPECT_EQ(rooms.add(beyond(along(i), rooms.seed++)).localisation.trust, ScanTrust::Uncertain) << i;
}

TEST(HeldByOdometry, OdometryThatBeganAnewInTheSmokeHoldsNothing) {
    TwoRooms rooms;
    const auto again = [](LiveScan scan) {
        scan.odometryFrame = 1;
        return scan;
    };
    rooms.add(again(withoutPoints(poseFrom({6.0, 0, 0.9}, 0, 0, 0), rooms.seed++)));
    EXPECT_EQ(rooms.add(again(beyond(along(0), rooms.seed++))).localisation.trust, ScanTrust::Uncertain)
        << "nobody knows how far it went before";
}

TEST(HeldByOdometry, WithoutOdometryNothingHolds) {
    TwoRooms rooms;
    LiveScan scan = beyond(along(0), rooms.seed++);
    auto without = std::make_shared<Scan>(*scan.scan);
    without->hasOdometry = false;
    scan.scan = std::move(without);
    EXPECT_EQ(rooms.add(scan).localisation.trust, ScanTrust::Uncertain);
}

TEST(HeldByOdometry, WhereTheRobotComesBackTheMapClosesByItself) {
    TwoRooms rooms;
    for (int i = 0; i < 4; ++i) rooms.add(beyond(along(i), rooms.seed++));
    // By now odometry errs by 0.5 m, which is what 28 m of way make of it.
    const Pose off = poseFrom({0.3, -0.4, 0}, 0, 0, degrees(3));
    bool closed = false;
    for (int i = 0; i < 6; ++i) {
        LiveScan back = scanAt(along(i), rooms.seed++);
        auto scan = std::make_shared<Scan>(*back.scan);
        scan->sensorInOdom = off * along(i);
        back.scan = std::move(scan);
        const MapUpdate update = rooms.add(back);
        EXPECT_EQ(update.localisation.trust, ScanTrust::Certain)
            << i << ": " << inWords(update.localisation.doubts);
        closed = closed || (update.loop && update.loop->links.front().active);
        rooms.solveAll();
    }
    EXPECT_TRUE(closed);
    const auto fix = rooms.mapper.fix("kurt3d");
    ASSERT_TRUE(fix);
    EXPECT_LT(distanceBetween(fix->baseInMap, rooms.mapInOdom * along(5)), 0.05)
        << "as if it had never erred";
}

}  // namespace
}  // namespace leitstand::test
