#include "app/services/mapping/live_mapping.h"

#include <array>
#include <future>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"
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

LiveKeyScan keyScan(std::uint64_t id, const std::vector<Label>& labels) {
    LiveKeyScan key;
    key.id = id;
    Scan scan;
    scan.points.resize(labels.size(), Eigen::Vector3f::Zero());
    scan.labels = labels;
    key.scan = std::make_shared<const Scan>(scan);
    key.pose.trust = ScanTrust::Certain;
    return key;
}

TEST(LiveMapping, TheMapThatIsShownIsTheSameWhetherOrNotAnEarlierOneIsKnown) {
    LiveMap live;
    live.scans = {keyScan(2, {Label::Floor, Label::Wall}), keyScan(4, {Label::Wall}),
                  keyScan(7, {Label::Ceiling, Label::Ceiling})};
    const auto earlier = shownMap(live);
    live.scans[1].pose.trust = ScanTrust::SetAside;
    live.scans[2] = keyScan(7, {Label::Floor});  // another one by that number
    live.scans.push_back(keyScan(9, {Label::Wall, Label::Wall, Label::Floor}));
    const auto counts = [](const MapPtr& map) {
        std::vector<std::array<std::size_t, LabelCount>> all;
        for (const MapScan& scan : map->scans) all.push_back(scan.labelCounts);
        return all;
    };
    const auto afresh = counts(shownMap(live));
    ASSERT_EQ(afresh.size(), 3U);
    EXPECT_EQ(afresh[2][static_cast<std::size_t>(Label::Wall)], 2U);
    EXPECT_EQ(counts(shownMap(live, earlier)), afresh);
    live.scans[1].pose.trust = ScanTrust::Certain;  // it comes back
    EXPECT_EQ(counts(shownMap(live, earlier)), counts(shownMap(live)));
}

TEST(LiveMapping, WhileAScanIsRegisteredAGoalIsToldRightlyInTheOdometry) {
    RobotDescription robot;
    robot.name = "crawler";
    LiveMapping mapping({robot}, "station", {}, {});
    const auto here = [&] { return mapping.robots()->front(); };
    const Pose put = poseFrom({3, 2, 0}, 0, 0, degrees(90));
    mapping.onEvent(odometryOf("crawler", Begin, Pose::Identity()));
    mapping.place("crawler", put);
    ASSERT_TRUE(waitUntil([&] { return here().odomInMap.has_value(); }, 60s));
    // The thread is busy; the robot drives on, and the mission knows it already.
    std::promise<void> done;
    mapping.post([busy = done.get_future().share()](LiveMapper&) { busy.wait(); });
    Pose newest = Pose::Identity();
    for (int i = 1; i <= 20; ++i) {
        newest = poseFrom({0.05 * i, 0, 0}, 0, 0, 0);
        mapping.onEvent(odometryOf("crawler", Begin + i * 50ms, newest));
    }
    const RobotInMap place = here();
    EXPECT_LT(distanceBetween(place.baseInMap, put), 1e-6) << "the place is of before";
    const Pose goal = poseFrom({3, 6, 0}, 0, 0, degrees(90));  // 4 m ahead of where it was put
    const Pose reported = goalInOdom(place.baseInMap, place.odomInMap->inverse() * place.baseInMap, goal);
    EXPECT_TRUE(reported.isApprox(poseFrom({4, 0, 0}, 0, 0, 0), 1e-6));
    EXPECT_NEAR(goalInOdom(place.baseInMap, newest, goal).translation().x(), 5.0, 1e-6)
        << "by the newest odometry it would drive too far";
    done.set_value();
    ASSERT_TRUE(waitUntil([&] { return here().stamp == Begin + 1s; }, 60s));
    EXPECT_TRUE(goalInOdom(here().baseInMap, here().odomInMap->inverse() * here().baseInMap, goal)
                    .isApprox(reported, 1e-6));
}

}  // namespace
}  // namespace leitstand::test
