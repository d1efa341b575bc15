#include <gtest/gtest.h>

#include "tests/app/services/scanning_robots.h"

namespace leitstand::test {
namespace {

TEST_F(ScanningRobots, OneThatWasCarriedFarIsFoundInTheWholeMap) {
    begin();
    for (int i = 0; i < 5; ++i) {
        const Pose way = poseFrom({0.4 * i, 0.1 * i, 0}, 0, 0, degrees(5.0 * i));
        scan("kurt3d", KurtBegins * way, way);
    }
    ASSERT_TRUE(waitUntil(
        [&] {
            const std::scoped_lock lock(m_mutex);
            return m_scans.size() >= 4;
        },
        60s));
    // Nobody told: its odometry stands still.
    const Pose stood = poseFrom({1.6, 0.4, 0}, 0, 0, degrees(20));
    const Pose there = poseFrom({2.6, -1.4, 0}, 0, 0, degrees(-150));
    scan("kurt3d", there, stood);
    ASSERT_TRUE(
        waitUntil([&] { return placeOf("kurt3d").stamp == m_time && !placeOf("kurt3d").certain; }, 20s));
    fragment("kurt3d", stood);
    ASSERT_TRUE(waitUntil([&] { return placeOf("kurt3d").stamp == m_time; }, 20s));
    m_mapping->lookFor("kurt3d");
    ASSERT_TRUE(waitUntil(
        [&] {
            const std::scoped_lock lock(m_mutex);
            return !m_places.empty();
        },
        60s))
        << "by the scan before: what a break left of one tells of no place";
    EXPECT_FALSE(placeOf("kurt3d").certain) << "until its next scan fits there";
    scan("kurt3d", there, stood);
    EXPECT_TRUE(stands("kurt3d", there)) << placeOf("kurt3d").how;
    const std::scoped_lock lock(m_mutex);
    ASSERT_FALSE(m_places.empty());
    EXPECT_EQ(m_places.back().cause, RobotPlaceSample::Cause::FoundAgain);
    EXPECT_FALSE(m_places.back().certain);
    EXPECT_LT(distanceBetween(m_places.back().baseInMap, inMap(there)), 0.05);
}

TEST_F(ScanningRobots, WhereTheOperatorPutsOneCountsMoreThanALookForItThatGoesOn) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    const Pose put = inMap(KurtBegins * poseFrom({0.3, 0.1, 0}, 0, 0, 0));
    m_mapping->lookFor("kurt3d");
    m_mapping->place("kurt3d", put);
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(m_mutex);
        return !m_places.empty();
    }));
    m_mapping->lookFor("crawler");  // nothing of it was scanned; done after the other look
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(m_mutex);
        return m_vain == std::vector<std::string>{"crawler"};
    }));
    scan("kurt3d", KurtBegins * poseFrom({0.4, 0.1, 0}, 0, 0, 0), poseFrom({0.1, 0, 0}, 0, 0, 0));
    EXPECT_TRUE(stands("kurt3d", KurtBegins * poseFrom({0.4, 0.1, 0}, 0, 0, 0)));
    const std::scoped_lock lock(m_mutex);
    for (const RobotPlaceSample& place : m_places)
        EXPECT_EQ(place.cause, RobotPlaceSample::Cause::Operator) << place.how;
}

TEST_F(ScanningRobots, WhereTheOperatorPutTheOneThatMakesTheMapIsInTheLog) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    const Pose put = inMap(KurtBegins * poseFrom({0.4, 0.1, 0}, 0, 0, degrees(5)));
    m_mapping->place("kurt3d", put);
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(m_mutex);
        return !m_places.empty();
    }));
    EXPECT_EQ(m_places.front().robot, "kurt3d");
    EXPECT_EQ(m_places.front().cause, RobotPlaceSample::Cause::Operator);
    EXPECT_TRUE(m_places.front().baseInMap.isApprox(put));
    EXPECT_FALSE(m_places.front().certain);
    EXPECT_EQ(m_places.front().how, logged(placement_format::PutUntilScan));
    EXPECT_EQ(m_places.front().measured, m_time);
    const Pose there = KurtBegins * poseFrom({0.5, 0, 0}, 0, 0, 0);
    scan("kurt3d", there);  // carried: its odometry does not know of it
    EXPECT_TRUE(stands("kurt3d", there));
}

TEST_F(ScanningRobots, OneThatFitsNowhereIsLookedForUnasked) {
    begin();
    for (int i = 0; i < 5; ++i) {
        const Pose way = poseFrom({0.4 * i, 0.1 * i, 0}, 0, 0, degrees(5.0 * i));
        scan("kurt3d", KurtBegins * way, way);
    }
    // Carried: its odometry stands still.
    const Pose stood = poseFrom({1.6, 0.4, 0}, 0, 0, degrees(20));
    const Pose there = poseFrom({2.6, -1.4, 0}, 0, 0, degrees(-150));
    const auto found = [&] {
        const std::scoped_lock lock(m_mutex);
        return !m_places.empty();
    };
    for (int i = 0; i < 9; ++i) {
        scan("kurt3d", there, stood);
        ASSERT_TRUE(waitUntil([&] { return placeOf("kurt3d").stamp == m_time; }, 20s));
    }
    EXPECT_FALSE(found()) << "what it sees from one place is not believed";
    for (int i = 1; i <= 12; ++i) stand("kurt3d", stood * poseFrom({0.05 * i, 0, 0}, 0, 0, 0), 50ms);
    const Pose on = poseFrom({0.6, 0, 0}, 0, 0, 0);
    for (int i = 0; i < 20 && !found(); ++i) {
        scan("kurt3d", there * on, stood * on);
        (void)waitUntil(found, 1s);
    }
    ASSERT_TRUE(found()) << "two that agree are";
    scan("kurt3d", there * on, stood * on);
    EXPECT_TRUE(stands("kurt3d", there * on)) << placeOf("kurt3d").how;
    const std::scoped_lock lock(m_mutex);
    EXPECT_EQ(m_places.back().cause, RobotPlaceSample::Cause::FoundAgain);
    EXPECT_TRUE(m_vain.empty()) << "nobody asked";
}

TEST_F(ScanningRobots, OneThatIsNowhereInTheMapForLongGoesOnInAPartOfItsOwn) {
    begin();
    scan("kurt3d", KurtBegins);
    scan("kurt3d", KurtBegins * poseFrom({0.4, 0, 0}, 0, 0, 0), poseFrom({0.4, 0, 0}, 0, 0, 0));
    ASSERT_TRUE(enters("kurt3d"));
    // Carried into another room, where it drives to and fro.
    m_room.length = 4.6;
    m_room.width = 3.4;
    m_room.height = 3.3;
    m_room.furnished = false;
    const auto ownPart = [&] { return placeOf("kurt3d").how == logged(placement_format::OwnPart); };
    int scans = 0;
    double ahead = 0.0;  // of where it was put down [m]
    for (; scans < 20 && !ownPart(); ++scans) {
        const double step = scans % 2 == 0 ? 0.06 : -0.06;
        for (int i = 0; i < 20; ++i) stand("kurt3d", poseFrom({0.4 + (ahead += step), 0, 0}, 0, 0, 0), 50ms);
        const Pose way = poseFrom({ahead, 0, 0}, 0, 0, 0);
        scan("kurt3d", poseFrom({-0.7, -0.2, 0}, 0, 0, degrees(90)) * way,
             poseFrom({0.4, 0, 0}, 0, 0, 0) * way);
        ASSERT_TRUE(waitUntil([&] { return placeOf("kurt3d").stamp == m_time; }, 20s));
    }
    EXPECT_TRUE(ownPart()) << placeOf("kurt3d").how;
    EXPECT_GE(scans, 9) << "10 m of way, and looked for in vain";
    EXPECT_LT(placeOf("kurt3d").baseInMap.translation().y(), -20.0) << "beside the map";
    const std::scoped_lock lock(m_mutex);
    EXPECT_TRUE(m_vain.empty()) << "nobody asked";
}

}  // namespace
}  // namespace leitstand::test
