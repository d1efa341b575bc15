#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include <gtest/gtest.h>

#include "core/mapping/live/scan_doubts.h"
#include "core/mapping/live/scan_work.h"
#include "tests/core/mapping/live/mapped_room.h"

namespace leitstand::test {
namespace {

const Pose Start = poseFrom({-1.4, 0, 0.9}, 0, 0, 0);

/// What was left of @p live after @p seen of its turn [rad].
LiveScan cutOff(LiveScan live, double seen, TurnEnd end) {
    Scan scan = *live.scan;
    for (Eigen::Vector3f& point : scan.points) {
        const double heading = std::atan2(point.y(), point.x()) + degrees(180);
        if (!(heading <= seen)) point.setConstant(std::numeric_limits<float>::quiet_NaN());
    }
    live.scan = std::make_shared<const Scan>(std::move(scan));
    live.end = end;
    return live;
}

/// @p live with its first @p points only.
LiveScan almostEmpty(LiveScan live, std::ptrdiff_t points) {
    Scan scan = *live.scan;
    std::fill(scan.points.begin() + points, scan.points.end(),
              Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    live.scan = std::make_shared<const Scan>(std::move(scan));
    return live;
}

TEST(LiveMapperEntry, AMapBeginsWithNoFragment) {
    for (const TurnEnd end : {TurnEnd::Break, TurnEnd::Distance}) {
        MappedRoom room;
        const MapUpdate fragment = room.add(cutOff(scanAt(Start, 1), degrees(200), end));
        EXPECT_FALSE(fragment.keyScan || fragment.poses);
        EXPECT_EQ(fragment.localisation.trust, ScanTrust::Uncertain);
        EXPECT_TRUE(room.mapper.map()->scans.empty());
        EXPECT_FALSE(room.mapper.fix("kurt3d")) << "there is no map to be in";
        const Pose next = Start * poseFrom({0.5, 0, 0}, 0, 0, degrees(20));
        const MapUpdate whole = room.add(next);
        ASSERT_TRUE(whole.keyScan);
        EXPECT_EQ(whole.localisation.trust, ScanTrust::Certain);
        EXPECT_TRUE(whole.keyScan->scanInMap.isApprox(Pose::Identity(), 1e-6)) << "it makes the frame";
    }
    MappedRoom room;
    EXPECT_TRUE(room.add(cutOff(scanAt(Start, 1), degrees(300), TurnEnd::Distance)).keyScan);
    EXPECT_TRUE(
        room.add(cutOff(scanAt(Start * poseFrom({0.4, 0, 0}, 0, 0, 0), 2), degrees(200), TurnEnd::Distance))
            .keyScan)
        << "where there is a map it is a scan like others";
}

TEST(LiveMapperEntry, AMapBeginsWithASweepThatLooksAheadOnly) {
    MappedRoom room;
    EXPECT_TRUE(room.add(cutOff(scanAt(Start, 1), degrees(180), TurnEnd::Sweep)).keyScan);
}

TEST(LiveMapperEntry, AMapBeginsWithNoScanThatSawNextToNothing) {
    MappedRoom room;
    EXPECT_FALSE(room.add(almostEmpty(scanAt(Start, 1), 100)).keyScan) << "a covered window";
    EXPECT_TRUE(room.mapper.map()->scans.empty());
    EXPECT_TRUE(room.add(Start).keyScan);
}

TEST(LiveMapperEntry, WhenAllWasRejectedAFragmentBeginsNothingEither) {
    MappedRoom room;
    room.drive(2);
    for (const std::uint64_t id : {1U, 2U}) room.log.publish(room.mapper.reject(id, room.now).value());
    const Pose next = Start * poseFrom({0.9, 0, 0}, 0, 0, 0);
    EXPECT_FALSE(room.add(cutOff(scanAt(next, 8), degrees(200), TurnEnd::Break)).keyScan);
    EXPECT_FALSE(room.add(almostEmpty(scanAt(next, 9), 100)).keyScan);
    EXPECT_EQ(room.mapper.map()->scans.size(), 2U);
    const MapUpdate whole = room.add(next);
    ASSERT_TRUE(whole.keyScan);
    EXPECT_EQ(whole.localisation.trust, ScanTrust::Certain);
    EXPECT_LT(distanceBetween(whole.keyScan->scanInMap, Start.inverse() * next), 0.03)
        << "odometry goes on from where the rejected ones were";
}

/// Of a scanner that a hand covers, nearly all of it.
LiveScan covered(const Pose& sensorInRoom, unsigned seed) {
    return almostEmpty(scanAt(sensorInRoom, seed), 150);
}

TEST(LiveMapperEntry, AStandingRobotThatIsLostTellsSoOnce) {
    MappedRoom room;
    room.drive(3);
    const Pose here = room.last;
    EXPECT_FALSE(room.add(here).keyScan) << "it stands, and fits";
    const MapUpdate lost = room.add(covered(here, 20));
    ASSERT_TRUE(lost.keyScan && lost.poses);
    EXPECT_EQ(lost.poses->poses[0].trust, ScanTrust::Uncertain);
    EXPECT_FALSE(room.add(covered(here, 21)).keyScan) << "still";
    EXPECT_FALSE(room.add(here).keyScan) << "it fits again";
    EXPECT_FALSE(room.add(covered(here, 22)).keyScan) << "one waits there to be decided on";
    room.add(here);
    room.log.publish(room.mapper.reject(lost.keyScan->id, room.now).value());
    EXPECT_TRUE(room.add(covered(here, 23)).keyScan) << "after that was decided it is news";
}

/// A turn of a robot that came @p ahead [m] since the last scan of @p room; its odometry is @p off [m] by
/// then.
LiveScan moving(MappedRoom& room, double ahead, double off) {
    room.last = room.last * Eigen::Translation3d(ahead, 0.0, 0.0);
    LiveScan scan = scanAt(room.last, room.seed++, Pose(Eigen::Translation3d(0.0, off, 0.0)));
    scan.way = 0.4;
    return scan;
}

MapUpdate pushed(MappedRoom& room, double ahead, double off) {
    return room.add(moving(room, ahead, off));
}

TEST(LiveMapperEntry, AScanOfARobotThatWasPushedWaitsForTheNextOne) {
    MappedRoom room;
    room.drive(3);
    EXPECT_FALSE(pushed(room, 0.4, 0.15).keyScan) << "its points were put together by what odometry told";
    EXPECT_EQ(room.poses().size(), 3U);
    EXPECT_TRUE(pushed(room, 0.0, 0.15).keyScan) << "odometry says the same of this one";
    // One that is pushed all the time is mapped, too.
    EXPECT_FALSE(pushed(room, 0.4, 0.3).keyScan);
    EXPECT_TRUE(pushed(room, 0.1, 0.45).keyScan);
    // One that would not have entered has not waited.
    EXPECT_FALSE(pushed(room, 0.1, 0.6).keyScan);
    EXPECT_FALSE(pushed(room, 0.3, 0.75).keyScan);
}

TEST(LiveMapperEntry, AScanTakenAtRestDoesNotWaitHoweverTheRobotCameThere) {
    MappedRoom room;
    room.drive(3);
    LiveScan sweep = moving(room, 0.4, 0.15);
    sweep.end = TurnEnd::Sweep;
    EXPECT_TRUE(room.add(sweep).keyScan);
    LiveScan atRest = moving(room, 0.4, 0.3);
    atRest.way = 0.0;
    EXPECT_TRUE(room.add(atRest).keyScan);
}

TEST(LiveMapperEntry, SurfacesFaceWhereTheyWereSeenFromAlsoOfARobotThatPassedThem) {
    // The plane x = 1, seen row by row while the sensor comes from x = 2.
    constexpr int Rows = 40, Columns = 30;
    Scan scan;
    scan.sweep = Sweep::Yawing;
    scan.rows = Rows;
    scan.columns = Columns;
    for (int row = 0; row < Rows; ++row) {
        for (int column = 0; column < Columns; ++column)
            scan.points.emplace_back(1.0F, 0.05F * static_cast<float>(row),
                                     0.05F * static_cast<float>(column) - 0.7F);
    }
    LiveScan live;
    live.scan = std::make_shared<const Scan>(scan);
    live.began = {2.0, 0.0, 0.0};
    const PointCloud reduced = readyScan(live, {}, Pose::Identity(), {}).reduced;
    std::size_t before = 0, after = 0;
    for (std::size_t i = 0; i < reduced.size(); ++i) {
        const float y = reduced.points[i].y(), x = reduced.normals[i].x();
        if (y < 0.85F && x > 0.9F) ++before;
        if (y > 1.15F && x < -0.9F) ++after;
        EXPECT_TRUE(y > 0.85F || x > 0.9F) << y;
        EXPECT_TRUE(y < 1.15F || x < -0.9F) << y;
    }
    EXPECT_GT(before, 50U);
    EXPECT_GT(after, 50U);
}

TEST(LiveMapperEntry, AScanFarFromTheLastOneEntersAlsoOfARobotThatWasPushed) {
    MappedRoom room;
    room.drive(3);
    EXPECT_TRUE(pushed(room, 0.7, 0.15).keyScan);
}

}  // namespace
}  // namespace leitstand::test
