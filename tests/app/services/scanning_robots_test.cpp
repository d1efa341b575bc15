#include <gtest/gtest.h>

#include "tests/app/services/scanning_robots.h"

namespace leitstand::test {
namespace {

TEST_F(ScanningRobots, TheSecondOneEntersFromItsSlotAlsoWhenTheStationStartsAgain) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    const EarlierMap earlier{m_scans, m_poses};
    scan("crawler", Slot);
    EXPECT_TRUE(enters("crawler"));
    EXPECT_TRUE(stands("crawler", Slot));
    m_mapping->close();
    m_scans.clear();
    begin(earlier);  // it was left before the second one came
    scan("crawler", Slot);
    EXPECT_TRUE(enters("crawler"));
    EXPECT_TRUE(stands("crawler", Slot));
}

TEST_F(ScanningRobots, WhoWalkedByIsLeftOutOfTheMapOnceOthersLookedThrough) {
    m_dense = true;
    begin();
    const Eigen::Vector2d somewhere(0.4, 1.6);
    const auto near = [&] {
        const std::scoped_lock lock(m_mutex);
        std::size_t points = 0;
        if (!m_map) return points;
        for (const LiveKeyScan& one : m_map->scans) {
            for (const Eigen::Vector3f& point : one.scan->points) {
                const Eigen::Vector3d there =
                    inMap(Pose::Identity()).inverse() * (one.pose.scanInMap * point.cast<double>());
                if (there.z() > 0.3 && there.z() < 1.5 && (there.head<2>() - somewhere).norm() < 0.3)
                    ++points;
            }
        }
        return points;
    };
    for (int i = 0; i < 7; ++i) {
        const Pose way = poseFrom({0.4 * i, -0.05 * i, 0}, 0, 0, degrees(4) * i);
        m_seen.clear();
        for (double z = 0.05; i == 1 && z < 1.7; z += 0.03) {
            for (double turn = 0.0; turn < 2.0 * M_PI; turn += 0.15)
                m_seen.emplace_back(somewhere.x() + 0.2 * std::cos(turn),
                                    somewhere.y() + 0.2 * std::sin(turn), z);
        }
        scan("kurt3d", KurtBegins * way, way);
        if (i == 1) {
            ASSERT_TRUE(waitUntil([&] { return near() > 200; }, 20s)) << "somebody is there";
        }
    }
    EXPECT_TRUE(waitUntil([&] { return near() < 20; }, 20s)) << near();
    const auto left = bodies();
    ASSERT_FALSE(left.empty()) << "the log has it";
    EXPECT_EQ(left.begin()->second.front().robot, PassingBodies::Name);
}

TEST_F(ScanningRobots, ARobotThatIsNowhereToBeFoundMapsAPartUntilSomebodySaysHowItLies) {
    begin();
    for (int i = 0; i < 5; ++i) {
        const Pose way = poseFrom({0.4 * i, -0.05 * i, 0}, 0, 0, degrees(4) * i);
        scan("kurt3d", KurtBegins * way, way);
    }
    ASSERT_TRUE(enters("kurt3d"));
    const Pose far = poseFrom({1.6, -1.4, 0}, 0, 0, degrees(130));
    scan("crawler", far);
    scan("crawler", far);
    EXPECT_FALSE(placeOf("crawler").placed);
    scan("crawler", far);
    ASSERT_TRUE(enters("crawler"));
    ASSERT_TRUE(waitUntil([&] { return placeOf("crawler").certain; }, 20s));
    EXPECT_EQ(placeOf("crawler").how, logged(placement_format::OwnPart));
    EXPECT_GT(distanceBetween(placeOf("crawler").baseInMap, inMap(far)), 10.0) << "aside";
    m_mapping->lookFor("crawler");
    const auto asked = [&] {
        const std::scoped_lock lock(m_mutex);
        return !m_questions.empty();
    };
    ASSERT_TRUE(waitUntil(asked, 30s)) << m_vain.size() << " times in vain";
    ScanLinksSample answer = m_questions.front();
    ASSERT_EQ(answer.links.front().kind, LinkKind::Session);
    for (Link& link : answer.links) {
        link.kind = LinkKind::Operator;
        link.active = true;
    }
    m_mapping->adopt(answer);
    EXPECT_TRUE(stands("crawler", far)) << placeOf("crawler").baseInMap.matrix();
    EXPECT_EQ(placeOf("crawler").how, logged(placement_format::FitsMap));
}

TEST_F(ScanningRobots, OneThatDroveOnWhileTheStationWasAwayIsFoundWhereItsOdometryWentTo) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    EarlierMap earlier{m_scans, m_poses};
    RobotPlaceSample place;  // as the log has it; none of its scans came in
    place.robot = "crawler";
    place.cause = RobotPlaceSample::Cause::Operator;
    place.measured = m_time;
    place.baseInMap = place.odomInMap = inMap(Slot);
    place.certain = true;
    place.certainty = 0.9;
    earlier.places.emplace("crawler", place);
    m_mapping->close();
    m_scans.clear();
    begin(earlier);
    const Pose way = poseFrom({2.2, 0.2, 0}, 0, 0, degrees(70));
    m_time += 60s;
    scan("crawler", Slot * way, way);
    EXPECT_TRUE(enters("crawler"));
    EXPECT_TRUE(stands("crawler", Slot * way)) << placeOf("crawler").how;
}

TEST_F(ScanningRobots, OneThatIsPlacedLateIsTakenOutOfWhatWasScannedBeforeAndStaysOut) {
    begin();
    m_seen = outsideOf(Slot);
    stand("crawler", Pose::Identity());
    scan("kurt3d", KurtBegins);
    stand("crawler", Pose::Identity(), 100ms);
    ASSERT_TRUE(enters("kurt3d"));
    ASSERT_TRUE(waitUntil([&] { return inMapAt(Slot) > 100; }, 20s)) << "nobody knows what that is";
    m_seen.clear();
    scan("crawler", Slot);
    ASSERT_TRUE(stands("crawler", Slot));
    ASSERT_TRUE(waitUntil([&] { return inMapAt(Slot) == 0; }, 20s)) << inMapAt(Slot);
    ASSERT_EQ(bodies().count(1), 1U) << "and that is said";
    EXPECT_EQ(bodies().at(1).front().robot, "crawler");
    EXPECT_LT(distanceBetween(inMap(Slot), bodies().at(1).front().baseInScan), 0.05);

    // Nobody knows where it is, while the other one sees it; found again, it is left out of that scan, too.
    const Pose aside = Slot * poseFrom({0.45, 0.1, 0}, 0, 0, degrees(10)),
               asideOdom = poseFrom({0.45, 0.1, 0}, 0, 0, degrees(10));
    m_mapping->place("crawler", inMap(Slot * poseFrom({-1.5, 0, 0}, 0, 0, 0)));
    ASSERT_TRUE(waitUntil([&] { return !placeOf("crawler").certain; }, 20s));
    m_seen = outsideOf(aside);
    stand("crawler", asideOdom);
    scan("kurt3d", KurtBegins * poseFrom({0.4, 0, 0}, 0, 0, 0), poseFrom({0.4, 0, 0}, 0, 0, 0));
    stand("crawler", asideOdom, 100ms);
    ASSERT_TRUE(waitUntil([&] { return inMapAt(aside) > 100; }, 20s)) << inMapAt(aside);
    m_seen.clear();
    m_mapping->place("crawler", inMap(aside));
    scan("crawler", aside, asideOdom);
    ASSERT_TRUE(stands("crawler", aside));
    ASSERT_TRUE(waitUntil([&] { return inMapAt(aside) == 0; }, 20s)) << inMapAt(aside);
    EXPECT_EQ(inMapAt(Slot), 0U);

    // It drives off and its odometry slips; it is put to where it is about, and found there.
    const Pose there = Slot * poseFrom({1.0, 0, 0}, 0, 0, 0), slipped = poseFrom({0.6, 0, 0}, 0, 0, 0);
    m_mapping->place("crawler", inMap(there));
    ASSERT_TRUE(waitUntil([&] { return !placeOf("crawler").certain; }, 20s));
    scan("crawler", there, slipped);
    ASSERT_TRUE(stands("crawler", there));
    stand("crawler", slipped);
    ASSERT_TRUE(waitUntil([&] { return placeOf("crawler").stamp == m_time; }, 20s));
    EXPECT_EQ(inMapAt(Slot), 0U) << "where it stood then is not told by where it would have stood by now";
    EXPECT_EQ(inMapAt(aside), 0U);

    m_mapping->close();
    EarlierMap earlier{m_scans, m_poses};
    earlier.bodies = bodies();
    m_map.reset();
    begin(earlier);
    ASSERT_TRUE(waitUntil([&] {
        const std::scoped_lock lock(m_mutex);
        return m_map != nullptr;
    }));
    EXPECT_EQ(inMapAt(Slot), 0U) << "after a resume, too";
    EXPECT_EQ(inMapAt(aside), 0U);
}

}  // namespace
}  // namespace leitstand::test
