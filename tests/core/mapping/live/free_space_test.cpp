#include "core/mapping/live/loops/places/free_space.h"

#include <vector>

#include <gtest/gtest.h>

#include "tests/support/rooms.h"

namespace leitstand {
namespace {

using test::RoomSettings;
using test::scanRoom;

RoomSettings room(double x, double length = 8.0) {
    RoomSettings settings;
    settings.length = length;
    settings.sensorInRoom = poseFrom({x, 0.3, 1.0}, 0.0, 0.0, 0.2 * x);
    settings.sweep = Sweep::Yawing;
    settings.rows = 360;
    settings.columns = 160;
    return settings;
}

double share(const RoomSettings& first, const RoomSettings& second, const Pose& shift = Pose::Identity()) {
    return filledShare(scanRoom(first).scan, scanRoom(second).scan,
                       shift * first.sensorInRoom.inverse() * second.sensorInRoom);
}

TEST(FreeSpace, OneRoomFillsNothingOfWhatWasSeenThroughInIt) {
    for (const double x : {0.2, 0.8, 1.6}) EXPECT_LT(share(room(0.0), room(x)), 0.02) << x;
}

TEST(FreeSpace, AWallWhereTheOtherLookedThroughFillsIt) {
    // Floor, ceiling and three walls agree; the fourth stands two metres nearer.
    const Pose left = poseFrom({-1.0, 0.0, 0.0}, 0.0, 0.0, 0.0);
    RoomSettings wide = room(0.0), narrow = room(1.0, 6.0);
    wide.furnished = narrow.furnished = false;
    EXPECT_GT(share(wide, narrow, left), 0.05);
    EXPECT_GT(share(narrow, wide, left.inverse()), 0.05) << "whichever is asked about";
}

TEST(FreeSpace, WhatIsHiddenOrWasNotSeenIsNotJudged) {
    const Scan scan = scanRoom(room(0.0)).scan;
    const FreeSpace seen(scan.points);
    std::vector<Eigen::Vector3f> behind;
    for (const Eigen::Vector3f& point : scan.points) behind.emplace_back(2.0F * point);
    const FreeSpaceFit fit = seen.fit(behind, Pose::Identity());
    EXPECT_EQ(fit.filled, 0U);
    EXPECT_EQ(fit.filledShare(), 0.0);
    EXPECT_EQ(FreeSpace({}).fit(scan.points, Pose::Identity()).agreed, 0U);
}

}  // namespace
}  // namespace leitstand
