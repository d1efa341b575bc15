#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "app/services/mapping/live_mapping.h"
#include "core/mapping/placement/placement_says.h"
#include "core/robot/robot_description.h"
#include "tests/support/rooms.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

const Pose LaserInBase = poseFrom({0, 0, 0.9}, 0, 0, 0);
const Pose KurtBegins = poseFrom({-1.0, 0.5, 0}, 0, 0, 0);  ///< base_link in the room ...
const Pose Slot = KurtBegins * poseFrom({0, -0.8, 0}, 0, 0, 0);

RobotDescription scanning(const std::string& name) {
    RobotDescription robot;
    robot.name = name;
    robot.title = name;
    robot.baseFrame = "base_link";
    robot.odomFrame = "odom";
    robot.footprint = {{0.2, 0.15}, {-0.2, 0.15}, {-0.2, -0.15}, {0.2, -0.15}};
    robot.height = 0.5;
    robot.sensors["laser"].sensorInBase = LaserInBase;
    StreamDescription points;
    points.topic = "/" + name + "/points";
    robot.streams.push_back(points);
    return robot;
}

/// A station's mapping, and two robots with 3D scanners and no others in the furnished room.
class ScanningRobots : public testing::Test {
protected:
    void begin(const EarlierMap& earlier = {}) {
        LiveMappingListener listener;
        listener.onUpdate = [this](const MapUpdate& update) {
            const std::scoped_lock lock(m_mutex);
            if (update.keyScan) m_scans.push_back(*update.keyScan);
            if (update.poses) m_poses = update.poses->poses;
        };
        listener.onBodies = [this](const ScanBodiesSample& bodies) {
            const std::scoped_lock lock(m_mutex);
            m_bodies.push_back(bodies);
        };
        listener.onLookedFor = [this](const std::string& robot, std::size_t) {
            const std::scoped_lock lock(m_mutex);
            m_vain.push_back(robot);
        };
        listener.onLoop = [this](const ScanLinksSample& question) {
            const std::scoped_lock lock(m_mutex);
            m_questions.push_back(question);
        };
        listener.onMap = [this](const LiveMapPtr& map) {
            const std::scoped_lock lock(m_mutex);
            m_map = map;
        };
        listener.onPlace = [this](const RobotPlaceSample& place) {
            const std::scoped_lock lock(m_mutex);
            m_places.push_back(place);
        };
        m_mapping = std::make_unique<LiveMapping>(std::vector{scanning("kurt3d"), scanning("crawler")}, "us",
                                                  LiveSettings{}, listener, earlier);
    }
    void TearDown() override { m_mapping->end(); }

    void say(const std::string& robot, StreamRole role, Sample sample) {
        Event event;
        event.received = m_time;
        event.robot = robot;
        event.role = role;
        event.topic = role == StreamRole::Points ? "/" + robot + "/points" : "/" + robot + "/odom";
        event.sensor = role == StreamRole::Points ? "laser" : "";
        event.sample = std::move(sample);
        m_mapping->take(event);
    }
    /// @p robot stands at @p baseInRoom, its odometry says @p baseInOdom, and looks around.
    void scan(const std::string& robot, const Pose& baseInRoom, const Pose& baseInOdom = Pose::Identity()) {
        stand(robot, baseInOdom);
        RoomSettings room;
        room.sensorInRoom = baseInRoom * LaserInBase;
        room.sweep = Sweep::Yawing;
        room.rows = m_dense ? 360 : 121;
        room.columns = m_dense ? 120 : 81;
        room.seed = ++m_seed;
        CloudSample cloud;
        cloud.header = {m_time, "laser"};
        for (const Eigen::Vector3f& point : scanRoom(room).scan.points) {
            if (point.allFinite()) cloud.points.push_back(point);
        }
        for (const Eigen::Vector3d& point : m_seen)
            cloud.points.push_back((room.sensorInRoom.inverse() * point).cast<float>());
        say(robot, StreamRole::Points, std::move(cloud));
    }
    /// A break leaves a few points of a turn.
    void fragment(const std::string& robot, const Pose& baseInOdom) {
        stand(robot, baseInOdom);
        CloudSample cloud;
        cloud.header = {m_time, "laser"};
        for (int i = 0; i < 40; ++i) cloud.points.emplace_back(2.0F, 0.02F * static_cast<float>(i), 0.3F);
        say(robot, StreamRole::Points, std::move(cloud));
    }
    /// @p robot is heard to stand where its odometry says @p baseInOdom.
    void stand(const std::string& robot, const Pose& baseInOdom, std::chrono::milliseconds time = 500ms) {
        for (auto passed = 0ms; passed < time; passed += 50ms) {
            m_time += 50ms;
            OdometrySample odometry;
            odometry.header = {m_time, "odom"};
            odometry.childFrame = "base_link";
            odometry.baseInOdom = baseInOdom;
            say(robot, StreamRole::Odometry, odometry);
        }
    }
    /// Points of the outside of a robot at @p baseInRoom, in the room.
    [[nodiscard]] static std::vector<Eigen::Vector3d> outsideOf(const Pose& baseInRoom) {
        std::vector<Eigen::Vector3d> points;
        for (double z = 0.1; z < 0.45; z += 0.02) {
            for (double along = -0.18; along < 0.18; along += 0.01) {
                points.push_back(baseInRoom * Eigen::Vector3d(along, 0.15, z));
                points.push_back(baseInRoom * Eigen::Vector3d(along, -0.15, z));
            }
        }
        return points;
    }
    /// Points in the map where a robot at @p baseInRoom is seen.
    [[nodiscard]] std::size_t inMapAt(const Pose& baseInRoom) {
        const std::scoped_lock lock(m_mutex);
        std::size_t points = 0;
        for (const LiveKeyScan& one : m_map->scans) {
            for (const Eigen::Vector3f& point : one.scan->points) {
                const Eigen::Vector3d there =
                    inMap(baseInRoom).inverse() * (one.pose.scanInMap * point.cast<double>());
                if (there.z() > 0.1 && there.z() < 0.45 && std::abs(there.x()) < 0.2 &&
                    std::abs(there.y()) < 0.2)
                    ++points;
            }
        }
        return points;
    }
    [[nodiscard]] std::map<std::uint64_t, std::vector<BodyInScan>> bodies() {
        const std::scoped_lock lock(m_mutex);
        std::map<std::uint64_t, std::vector<BodyInScan>> all;
        for (const ScanBodiesSample& sample : m_bodies) {
            for (const BodiesOfScan& one : sample.scans) all[one.scan] = one.bodies;
        }
        return all;
    }
    [[nodiscard]] bool enters(const std::string& robot) {
        return waitUntil(
            [&] {
                const std::scoped_lock lock(m_mutex);
                return std::any_of(m_scans.begin(), m_scans.end(),
                                   [&](const KeyScanSample& one) { return one.scan->robot == robot; });
            },
            60s);
    }
    [[nodiscard]] RobotInMap placeOf(const std::string& robot) const {
        const RobotsInMapPtr robots = m_mapping->robots();
        return *std::find_if(robots->begin(), robots->end(),
                             [&](const RobotInMap& one) { return one.robot == robot; });
    }
    /// The map begins at Kurt3D's scanner.
    [[nodiscard]] static Pose inMap(const Pose& baseInRoom) {
        return (KurtBegins * LaserInBase).inverse() * baseInRoom;
    }
    [[nodiscard]] bool stands(const std::string& robot, const Pose& baseInRoom) const {
        return waitUntil(
            [&] {
                const RobotInMap place = placeOf(robot);
                return place.certain && distanceBetween(place.baseInMap, inMap(baseInRoom)) < 0.05;
            },
            20s);
    }

    std::mutex m_mutex;
    std::vector<KeyScanSample> m_scans;
    std::vector<ScanPose> m_poses;
    std::vector<RobotPlaceSample> m_places;
    std::vector<ScanBodiesSample> m_bodies;
    std::vector<ScanLinksSample> m_questions;  ///< about places that were recognised
    std::vector<std::string> m_vain;           ///< were looked for, and not found
    LiveMapPtr m_map;
    std::vector<Eigen::Vector3d> m_seen;  ///< what scanners see beside the room, in the room
    bool m_dense = false;                 ///< as many points as a real scanner has in a turn
    Time m_time = Time(1'700'000'000s);
    unsigned m_seed = 0;
    std::unique_ptr<LiveMapping> m_mapping;
};

TEST_F(ScanningRobots, TheSecondOneEntersFromItsSlotAlsoWhenTheStationStartsAgain) {
    begin();
    scan("kurt3d", KurtBegins);
    ASSERT_TRUE(enters("kurt3d"));
    const EarlierMap earlier{m_scans, m_poses};
    scan("crawler", Slot);
    EXPECT_TRUE(enters("crawler"));
    EXPECT_TRUE(stands("crawler", Slot));
    m_mapping->end();
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
    EXPECT_EQ(placeOf("crawler").how, placement_says::OwnPart);
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
    EXPECT_EQ(placeOf("crawler").how, placement_says::FitsMap);
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
    m_mapping->end();
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

    m_mapping->end();
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
    EXPECT_EQ(m_places.front().how, placement_says::PutUntilScan);
    EXPECT_EQ(m_places.front().measured, m_time);
    const Pose there = KurtBegins * poseFrom({0.5, 0, 0}, 0, 0, 0);
    scan("kurt3d", there);  // carried: its odometry does not know of it
    EXPECT_TRUE(stands("kurt3d", there));
}

}  // namespace
}  // namespace leitstand::test
