#include "app/services/preflight/preflight_desk.h"

#include <algorithm>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/station/choose_robots.h"
#include "core/event/stream_role.h"
#include "tests/app/station/station_scene.h"
#include "tests/support/places.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Kind = PreflightCheck::Kind;

class PreflightDeskTest : public StationScene {
protected:
    [[nodiscard]] std::vector<PreflightCheck> checks(const PreflightDesk& desk) const {
        return preflight(desk.facts("Test pad"));
    }
    [[nodiscard]] static const PreflightCheck* find(const std::vector<PreflightCheck>& checks, Kind kind) {
        const auto found =
            std::find_if(checks.begin(), checks.end(), [&](const auto& one) { return one.kind == kind; });
        return found == checks.end() ? nullptr : &*found;
    }
};

TEST_F(PreflightDeskTest, FindsWhatIsInOrderAndARobotThatMayBeAdded) {
    const auto config = m_folder / "config";
    ASSERT_EQ(setenv("XDG_CONFIG_HOME", config.c_str(), 1), 0);
    auto arguments = kurtArguments();
    arguments.insert(arguments.end(), {"--name", "rover"});
    const ChildProcess rover(program("leitstand-robot"), arguments);
    std::string file;
    {
        const auto station = stationFor({kurt3d()});
        PreflightDesk desk(*station);
        ASSERT_TRUE(waitUntil([&] { return !desk.strangers().empty(); }, 60s)) << rover.out();
        ASSERT_TRUE(waitUntil([&] { return desk.facts({}).writeRate.has_value(); }, 60s));
        const auto found = checks(desk);
        ASSERT_NE(find(found, Kind::RobotMissing), nullptr) << "kurt3d is not there";
        EXPECT_EQ(find(found, Kind::RobotMissing)->state, CheckState::Fail);
        ASSERT_NE(find(found, Kind::Stranger), nullptr);
        EXPECT_EQ(find(found, Kind::Stranger)->detail, "rover");
        EXPECT_NE(find(found, Kind::Gamepad), nullptr);
        EXPECT_NE(find(found, Kind::Open), nullptr);
        EXPECT_THAT(desk.facts({}).cards, testing::Not(testing::IsEmpty()));
        EXPECT_EQ(find(found, Kind::Versions)->detail, "Leitstand test");
        // All its topics are there by now, as far as this test needs them.
        ASSERT_TRUE(waitUntil(
            [&] {
                const auto strangers = desk.strangers();
                return !strangers.empty() &&
                       strangers.front().robot.stream(StreamRole::DriveCommand) != nullptr &&
                       strangers.front().robot.stream(StreamRole::Picture) != nullptr;
            },
            60s));
        file = must(writeFirstFile(desk.strangers().front().robot, station->robots()));
        const auto joins = checkJoins(file, station->robots());
        EXPECT_TRUE(joins.ok()) << joins.error().text;
        EXPECT_EQ(must(writeFirstFile(desk.strangers().front().robot, {})), file) << "never written over";
    }
    auto team = must(chooseRobots({file}));
    EXPECT_EQ(team.front().name, "rover");
    team.insert(team.begin(), kurt3d());
    const auto station = stationFor(team);
    EXPECT_TRUE(waitUntil([&] { return station->robot("rover").link.state == LinkState::Connected; }, 60s))
        << words();
    PreflightDesk desk(*station);
    EXPECT_TRUE(waitUntil([&] { return find(checks(desk), Kind::PicturesFresh) != nullptr; }, 60s));
    EXPECT_NE(find(checks(desk), Kind::BrakeUntested), nullptr);
    EXPECT_TRUE(desk.strangers().empty());
}

TEST_F(PreflightDeskTest, ARobotWithAnotherQosOrTypeThanItsFileSaysIsTold) {
    RobotDescription robot = kurt3d();
    const auto asked =
        std::find_if(robot.streams.begin(), robot.streams.end(),
                     [](const StreamDescription& stream) { return stream.role == StreamRole::Odometry; });
    ASSERT_NE(asked, robot.streams.end());
    asked->qos = reliable(5);
    const StreamDescription odometry = *asked;
    const StreamDescription* const points = robot.stream(StreamRole::Points);
    ASSERT_NE(points, nullptr);
    const auto node = nodeIn(m_domain, {.name = "kurt3d"});
    const auto careless = must(node->publisher({odometry.topic, odometry.type, bestEffort()}));
    const auto other = must(node->publisher({points->topic, "sensor_msgs/msg/LaserScan", reliable(5)}));
    const auto station = stationFor({robot});
    const PreflightDesk desk(*station);

    const WireComplaint qos{odometry.topic, {{WireProblem::Kind::OffersLess, "best effort", "reliable"}}};
    const WireComplaint type{points->topic,
                             {{WireProblem::Kind::SendsOther, "sensor_msgs/msg/LaserScan", points->type}}};
    const auto isTold = [&](const WireComplaint& complaint) {
        const auto found = checks(desk);
        return std::any_of(found.begin(), found.end(), [&](const PreflightCheck& one) {
            return one.kind == Kind::Wire && one.robot == "kurt3d" && one.wire == complaint &&
                   one.state == CheckState::Attention;
        });
    };
    EXPECT_TRUE(waitUntil([&] { return isTold(qos) && isTold(type); }, 30s)) << words();
    EXPECT_TRUE(waitUntil([&] { return words().find(toString(qos)) != std::string::npos; }, 30s))
        << "messages tell it too: " << words();
}

TEST_F(PreflightDeskTest, ADiskIsMeasuredAndLeavesNothingBehind) {
    const auto rate = measureDisk(m_folder / ".", 2);
    ASSERT_TRUE(rate.ok());
    EXPECT_GT(*rate, 1e5);
    EXPECT_FALSE(std::filesystem::exists(m_folder / ".disk-test"));
    EXPECT_FALSE(measureDisk("/no/such/folder").ok());
}

}  // namespace
}  // namespace leitstand::test
