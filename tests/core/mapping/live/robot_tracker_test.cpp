#include "core/mapping/live/robot_tracker.h"

#include <gtest/gtest.h>

#include "tests/core/mapping/live/slices.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

const Time Begin(1000s);

/// A robot that drives 0.5 m/s along its odometry's x.
struct Drive {
    RobotTracker tracker{"kurt3d"};
    Time now = Begin;
    double way = 0.0;
    void pass(double seconds, double speed = 0.5) {
        for (int i = 0; i < static_cast<int>(20.0 * seconds + 0.5); ++i) {
            now += 50ms;
            way += speed / 20.0;
            tracker.add(odometryAt(now, poseFrom({way, 0, 0}, 0, 0, 0)), now);
        }
    }
};

TEST(RobotTracker, CarriesAFixOnByTheOdometryAndLeavesATrail) {
    Drive drive;
    drive.pass(1.0);
    EXPECT_FALSE(drive.tracker.now().placed);
    const Pose fix = poseFrom({3, 2, 0}, 0, 0, degrees(90));
    drive.tracker.correct({drive.now - 500ms, fix, 0.8, true, "fits"});
    const RobotInMap& here = drive.tracker.now();
    EXPECT_TRUE(here.placed && here.certain);
    EXPECT_LT((here.baseInMap.translation() - Eigen::Vector3d(3, 2.25, 0)).norm(), 1e-6);
    drive.pass(4.0);
    EXPECT_LT((here.baseInMap.translation() - Eigen::Vector3d(3, 4.25, 0)).norm(), 1e-6);
    EXPECT_EQ(here.stamp, drive.now);
    EXPECT_NEAR(static_cast<double>(here.trail->size()), 20.0, 3.0);
    const auto before = here.trail;
    drive.pass(5.0, 0.0);
    EXPECT_EQ(here.trail, before) << "it stands";
    drive.tracker.lose();
    EXPECT_FALSE(here.placed);
}

TEST(RobotTracker, APlaceAndItsOdometryAreOfOneMoment) {
    Drive drive;
    drive.pass(1.0);
    EXPECT_FALSE(drive.tracker.now().odomInMap);
    drive.tracker.correct({drive.now - 500ms, poseFrom({3, 2, 0}, 0, 0, degrees(90)), 0.8, true, "fits"});
    drive.pass(1.0);
    const RobotInMap here = drive.tracker.now();
    ASSERT_TRUE(here.odomInMap);
    const Pose inOdom = here.odomInMap->inverse() * here.baseInMap;
    EXPECT_LT((inOdom.translation() - Eigen::Vector3d(drive.way, 0, 0)).norm(), 1e-6);
    // Where it is does not depend on how far it went since.
    drive.pass(2.0);
    EXPECT_TRUE(drive.tracker.now().odomInMap->isApprox(*here.odomInMap, 1e-9));
    drive.way = 30.0;
    drive.pass(0.1, 0.0);
    EXPECT_TRUE(drive.tracker.now().placed);
    drive.tracker.lose();
    EXPECT_FALSE(drive.tracker.now().odomInMap);
}

TEST(RobotTracker, AFixFromBeforeTheOdometryHoldsUntilTheRobotMoves) {
    Drive drive;
    const Pose fix = poseFrom({3, 2, 0}, 0, 0, degrees(90));
    drive.tracker.correct({Begin - 1h, fix, 0.8, true, "fits"});
    EXPECT_TRUE(drive.tracker.now().placed);
    EXPECT_TRUE(drive.tracker.now().baseInMap.isApprox(fix));
    drive.way = 40.0;
    drive.pass(2.0);
    EXPECT_LT((drive.tracker.now().baseInMap.translation() - Eigen::Vector3d(3, 2.975, 0)).norm(), 1e-6);
}

TEST(RobotTracker, OdometryThatBeginsAnewGoesOnFromWhereTheRobotWasButIsDoubted) {
    Drive drive;
    drive.tracker.correct({Begin, poseFrom({3, 2, 0}, 0, 0, 0), 0.8, true, "fits"});
    drive.pass(2.0);
    const Pose before = drive.tracker.now().baseInMap;
    drive.way = 30.0;
    drive.pass(0.1, 0.0);
    EXPECT_FALSE(drive.tracker.now().certain);
    EXPECT_FALSE(drive.tracker.now().how.empty());
    EXPECT_LT(distanceBetween(drive.tracker.now().baseInMap, before), 0.03);
    drive.pass(1.0);
    EXPECT_NEAR(distanceBetween(drive.tracker.now().baseInMap, before), 0.5, 0.05);
}

TEST(RobotTracker, TheTrailMovesWithTheScansThatItIsKnownBy) {
    Drive drive;
    drive.pass(0.1, 0.0);
    drive.tracker.correct({drive.now, Pose::Identity(), 0.8, true, "fits"});
    const Time half = drive.now + 2s;
    drive.pass(4.0);
    const RobotInMap& here = drive.tracker.now();
    const std::size_t points = here.trail->size();
    const auto before = here.trail;
    drive.tracker.layTrail({});
    EXPECT_TRUE(*here.trail == *before) << "nothing is known of it";
    // The second half was shifted by a metre, and a scan of other odometry says nothing.
    const std::vector<TrailAnchor> anchors = {{half, 0, poseFrom({0, 1, 0}, 0, 0, 0)},
                                              {Begin, 0, Pose::Identity()},
                                              {Begin, 1, poseFrom({0, 7, 0}, 0, 0, 0)}};
    drive.tracker.layTrail(anchors);
    ASSERT_EQ(here.trail->size(), points);
    for (const auto& [point, gap] : *here.trail) {
        if (std::abs(point.x() - 1.0F) < 0.1F) continue;
        EXPECT_NEAR(point.y(), point.x() > 1.0F ? 1.0F : 0.0F, 1e-5F) << point.x();
    }
    const std::vector<TrailAnchor> undone = {{Begin, 0, Pose::Identity()}};
    drive.tracker.layTrail(undone);
    for (std::size_t i = 0; i < points; ++i)
        EXPECT_LT(((*here.trail)[i].inMap - (*before)[i].inMap).norm(), 1e-5F);
}

TEST(RobotTracker, ALongTrailIsThinned) {
    Drive drive;
    drive.tracker.correct({Begin, Pose::Identity(), 0.8, true, "fits"});
    drive.pass(450.0, 2.0);
    EXPECT_LE(drive.tracker.now().trail->size(), 4001u);
    EXPECT_GE(drive.tracker.now().trail->size(), 2000u);
    EXPECT_LT(drive.tracker.now().trail->front().inMap.norm(), 0.3f);
}

/// Places of the trail to which nobody knows the way.
std::vector<Eigen::Vector3f> gapsOf(const RobotTracker& tracker) {
    std::vector<Eigen::Vector3f> gaps;
    for (const TrailPlace& place : *tracker.now().trail) {
        if (place.afterGap) gaps.push_back(place.inMap);
    }
    return gaps;
}

TEST(RobotTracker, TheTrailHasAGapWhereNothingWasHeardOfTheWay) {
    Drive drive;
    drive.tracker.correct({Begin, Pose::Identity(), 0.8, true, "fits"});
    drive.pass(2.0);
    drive.now += 30s;  // the link was lost, and the robot stood
    drive.pass(2.0);
    EXPECT_TRUE(gapsOf(drive.tracker).empty());
    drive.now += 30s;  // ... and drove on meanwhile
    drive.way += 0.8;
    drive.pass(2.0);
    ASSERT_EQ(gapsOf(drive.tracker).size(), 1U);
    EXPECT_NEAR(gapsOf(drive.tracker).front().x(), 2.8, 0.06);
    drive.now += 30s;
    drive.pass(0.0);
    EXPECT_FALSE(drive.tracker.now().afterGap);
}

TEST(RobotTracker, TheTrailHasAGapWhereTheRobotsPlaceJumps) {
    Drive drive;
    drive.tracker.correct({Begin, Pose::Identity(), 0.8, true, "fits"});
    drive.pass(2.0);
    drive.tracker.correct({drive.now, poseFrom({1.3, 0.2, 0}, 0, 0, 0), 0.8, true, "fits"});
    drive.pass(1.0);
    EXPECT_TRUE(gapsOf(drive.tracker).empty()) << "a scan corrects it a little";
    drive.tracker.correct({drive.now, poseFrom({5, 5, 0}, 0, 0, 0), 0.8, true, "put there"});
    EXPECT_TRUE(drive.tracker.now().afterGap) << "until it moves";
    drive.pass(1.0);
    EXPECT_FALSE(drive.tracker.now().afterGap);
    ASSERT_EQ(gapsOf(drive.tracker).size(), 1U);
    EXPECT_NEAR(gapsOf(drive.tracker).front().y(), 5.0, 0.01);
    drive.tracker.lose();
    drive.pass(20.0);
    drive.tracker.correct({drive.now, poseFrom({9, 5, 0}, 0, 0, 0), 0.8, true, "found again"});
    drive.pass(0.5);
    EXPECT_EQ(gapsOf(drive.tracker).size(), 2U);
}

TEST(RobotTracker, ATrailThatIsThinnedOrTornHasItsGaps) {
    Drive drive;
    drive.tracker.correct({Begin, Pose::Identity(), 0.8, true, "fits"});
    drive.pass(100.0, 2.0);
    const Time half = drive.now;
    drive.now += 30s;
    drive.way += 0.9;
    drive.pass(250.0, 2.0);
    drive.pass(10.0, 0.0);
    drive.pass(100.0, 2.0);
    ASSERT_EQ(gapsOf(drive.tracker).size(), 1U) << "places stand farther apart now";
    EXPECT_NEAR(gapsOf(drive.tracker).front().x(), 200.9, 0.3);
    const std::vector<TrailAnchor> torn = {{half + 31s, 0, poseFrom({0, 3, 0}, 0, 0, 0)},
                                           {Begin, 0, Pose::Identity()}};
    drive.tracker.layTrail(torn);
    EXPECT_EQ(gapsOf(drive.tracker).size(), 2U);
}

/// Two scans 10 m apart along x.
LiveMap twoScans(const Pose& secondMoved) {
    LiveMap map;
    for (const std::uint64_t id : {1U, 2U}) {
        LiveKeyScan scan;
        scan.id = id;
        scan.pose.scan = id;
        scan.pose.scanInMap = poseFrom({10.0 * static_cast<double>(id - 1), 0, 0}, 0, 0, 0);
        if (id == 2) scan.pose.scanInMap = secondMoved * scan.pose.scanInMap;
        map.scans.push_back(scan);
    }
    return map;
}

TEST(RobotTracker, GoesWithTheScansAboutItWhenTheMapMovesAndSoDoesEachPlaceOfItsTrail) {
    Drive drive;
    drive.pass(1.0);
    drive.tracker.correct({drive.now, poseFrom({2, 1, 0}, 0, 0, 0), 0.8, true, "fits"});
    drive.pass(14.0);  // 7 m on: nearer to the second scan
    const RobotInMap before = drive.tracker.now();
    const Pose moved = poseFrom({0.3, -0.2, 0.1}, 0, 0, degrees(5));
    const LiveMap was = twoScans(Pose::Identity()), is = twoScans(moved);
    EXPECT_FALSE(MovedPlaces(was, was).any());
    drive.tracker.move(MovedPlaces(was, is));
    const RobotInMap after = drive.tracker.now();
    EXPECT_TRUE(after.baseInMap.isApprox(moved * before.baseInMap, 1e-9));
    ASSERT_TRUE(after.odomInMap);
    EXPECT_TRUE(after.odomInMap->isApprox(moved * *before.odomInMap, 1e-9)) << "of the same moment";
    ASSERT_EQ(after.trail->size(), before.trail->size());
    EXPECT_EQ(after.trail->front().inMap, before.trail->front().inMap) << "the first scan did not move";
    const Eigen::Vector3d end = before.trail->back().inMap.cast<double>();
    EXPECT_LT((after.trail->back().inMap.cast<double>() - moved * end).norm(), 1e-5);
    drive.pass(1.0);
    EXPECT_LT(distanceBetween(drive.tracker.now().baseInMap,
                              moved * before.baseInMap * poseFrom({0.5, 0, 0}, 0, 0, 0)),
              1e-6)
        << "it goes on from there";
}

}  // namespace
}  // namespace leitstand::test
