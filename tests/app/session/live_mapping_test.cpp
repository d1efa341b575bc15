#include "app/session/station/live_mapping.h"

#include <future>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "core/io/robot/robot_file.h"
#include "core/robot/goal.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

constexpr Time Begin(1'700'000'000s);

Event odometryOf(const std::string& robot, Time stamp, const Pose& baseInOdom) {
    OdometrySample sample;
    sample.header.stamp = stamp;
    sample.baseInOdom = baseInOdom;
    Event event;
    event.received = stamp;
    event.robot = robot;
    event.role = StreamRole::Odometry;
    event.sample = sample;
    return event;
}

TEST(LiveMapping, RefinesTheTurnsOfThoseRobotsWhoseFileSaysSo) {
    const std::string head = "letter: K\nstreams: [{role: points}]\nname: ";
    const RobotDescription poor = parseRobot(head + "poor\nrefine_turns: true\n", "poor.yaml").value();
    const RobotDescription good = parseRobot(head + "good\n", "good.yaml").value();
    LiveSettings given;
    given.kept = 0.03;
    const LiveSettings settings = settingsOf({poor, good}, given);
    EXPECT_EQ(settings.refined, std::set<std::string>{"poor"});
    EXPECT_FALSE(settings.refinement.on) << "the others are left as they are";
    EXPECT_EQ(settings.kept, 0.03);
}

TEST(LiveMapping, WhileAScanIsRegisteredAGoalIsToldRightlyInTheOdometry) {
    RobotDescription robot;
    robot.name = "crawler";
    LiveMapping mapping({robot}, "station", {}, {});
    const auto here = [&] { return mapping.robots()->front(); };
    const Pose put = poseFrom({3, 2, 0}, 0, 0, degrees(90));
    mapping.take(odometryOf("crawler", Begin, Pose::Identity()));
    mapping.place("crawler", put);
    ASSERT_TRUE(waitUntil([&] { return here().odomInMap.has_value(); }, 60s));
    // The thread is busy; the robot drives on, and the mission knows it already.
    std::promise<void> done;
    mapping.post([busy = done.get_future().share()](LiveMapper&) { busy.wait(); });
    Pose newest = Pose::Identity();
    for (int i = 1; i <= 20; ++i) {
        newest = poseFrom({0.05 * i, 0, 0}, 0, 0, 0);
        mapping.take(odometryOf("crawler", Begin + i * 50ms, newest));
    }
    const RobotInMap place = here();
    EXPECT_LT(distanceBetween(place.baseInMap, put), 1e-6) << "the place is of before";
    const Pose goal = poseFrom({3, 6, 0}, 0, 0, degrees(90));  // 4 m ahead of where it was put
    const Pose told = goalInOdom(place.baseInMap, place.odomInMap->inverse() * place.baseInMap, goal);
    EXPECT_TRUE(told.isApprox(poseFrom({4, 0, 0}, 0, 0, 0), 1e-6));
    EXPECT_NEAR(goalInOdom(place.baseInMap, newest, goal).translation().x(), 5.0, 1e-6)
        << "by the newest odometry it would drive too far";
    done.set_value();
    ASSERT_TRUE(waitUntil([&] { return here().stamp == Begin + 1s; }, 60s));
    EXPECT_TRUE(goalInOdom(here().baseInMap, here().odomInMap->inverse() * here().baseInMap, goal)
                    .isApprox(told, 1e-6));
}

}  // namespace
}  // namespace leitstand::test
