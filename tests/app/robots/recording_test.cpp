#include <cstdio>
#include <set>
#include <string>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/event/stream_role.h"
#include "tests/app/recording.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/link/control_station.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using testing::HasSubstr;

/// Waits until @p mission holds so much on @p topic; looks at it five times a second.
bool holds(const std::filesystem::path& mission, const std::string& topic, std::size_t atLeast,
           std::chrono::seconds atMost = 90s) {
    return waitUntil(
        [&] {
            if (recordedOn(mission, topic).size() >= atLeast) return true;
            std::this_thread::sleep_for(200ms);
            return false;
        },
        atMost);
}

/// Topics of @p robot that come without anybody asking, when it stands and sees no victim.
std::set<std::string> topicsOf(const RobotDescription& robot, bool points) {
    std::set<std::string> topics;
    for (const StreamDescription& stream : robot.streams) {
        const bool onDemand = stream.role == StreamRole::Pong || stream.role == StreamRole::Sightings;
        if (isCommand(stream.role) || onDemand || (stream.role == StreamRole::Points && !points)) continue;
        topics.insert(stream.topic);
    }
    return topics;
}

TEST(RobotRecording, BothRobotsAreTakenWithAllTheirStreamsAndKurt3dsScansFitTheTruth) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    const TestDomain domain;
    Truth truth(domain, "yellow_7", "");
    Recording recording(domain, mission, {"--robot", "kurt3d", "crawler"});
    RobotProcess kurt3d(domain, "kurt3d", {"--arena", "yellow", "--seed", "7"});
    RobotProcess crawler(domain, "crawler", {"--arena", "yellow", "--seed", "7"});
    EXPECT_EQ(kurt3d.out(), "kurt3d is in yellow 7 on domain " + std::to_string(domain.number()) + "\n");
    ASSERT_TRUE(recording.says("kurt3d: connected") && recording.says("crawler: connected"))
        << recording.out();
    ASSERT_TRUE(truth.listener().receives(truth.topic("kurt3d")));
    // Three turns of 23 slices, from when the truth is heard.
    ASSERT_TRUE(holds(mission, "/kurt3d/points", recordedOn(mission, "/kurt3d/points").size() + 72));
    std::set<std::string> expected = topicsOf(shippedRobot("kurt3d"), true);
    expected.merge(topicsOf(shippedRobot("crawler"), false));
    for (const std::string& topic : expected) EXPECT_TRUE(holds(mission, topic, 1, 30s)) << topic;
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    EXPECT_EQ(kurt3d.end(), 0);
    EXPECT_EQ(crawler.end(), 0);

    const auto info = leitstandctl({"info", mission.string(), "--json"});
    ASSERT_EQ(info.exitCode, 0) << info.err;
    const json reported = json::parse(info.out);
    EXPECT_EQ(reported["problems"].size(), 0u) << info.out;
    for (const json& topic : reported["topics"]) {
        if (topic["messages"].get<int>() > 0) expected.erase(topic["topic"].get<std::string>());
    }
    EXPECT_THAT(expected, testing::IsEmpty()) << "not told by info";

    const Registered registered = registerAgainst(truth, mission, shippedRobot("kurt3d"));
    EXPECT_THAT(registered.problems, testing::IsEmpty());
    std::printf("standing: %d scans, worst %.1f mm and %.2f degrees off\n", registered.scans,
                1e3 * registered.worstPosition, inDegrees(registered.worstTurn));
    EXPECT_GE(registered.scans, 2);
    EXPECT_LT(registered.worstPosition, 0.03);
    EXPECT_LT(registered.worstTurn, degrees(1.0));
}

TEST(RobotRecording, TheTiltingScannersSweepsFitTheTruth) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    const TestDomain domain;
    Truth truth(domain, "yellow_7", "");
    Recording recording(domain, mission, {"--robot", "kurt3d"});
    RobotProcess kurt3d(domain, "kurt3d", {"--arena", "yellow", "--seed", "7", "--tilting"});
    ASSERT_TRUE(truth.listener().receives(truth.topic("kurt3d")));
    ASSERT_TRUE(holds(mission, "/kurt3d/points", recordedOn(mission, "/kurt3d/points").size() + 3));
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    const Registered registered = registerAgainst(truth, mission, shippedRobot("kurt3d"));
    EXPECT_THAT(registered.problems, testing::IsEmpty());
    EXPECT_GE(registered.scans, 2) << "a sweep is a scan";
    EXPECT_LT(registered.worstPosition, 0.03);
    EXPECT_LT(registered.worstTurn, degrees(1.0));
}

TEST(RobotRecording, InASecuredDomainOnlyMembersHearTheRobot) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission", nothing = folder / "nothing", keys = folder / "keys";
    const auto made =
        leitstandctl({"keys", "--out", keys.string(), "--station", "station1", "--robot", "kurt3d"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const TestDomain domain;
    Recording stranger(domain, nothing, {"--robot", "kurt3d"});
    Recording member(domain, mission,
                     {"--robot", "kurt3d", "--keys", (keys / "enclaves" / "station1").string()});
    RobotProcess robot(domain, "kurt3d", {"--seed", "7", "--keys", (keys / "enclaves" / "kurt3d").string()});
    for (const std::string& topic : topicsOf(shippedRobot("kurt3d"), true))
        EXPECT_TRUE(holds(mission, topic, 1)) << topic << member.out();
    ASSERT_TRUE(holds(mission, "/kurt3d/points", 20)) << member.out();
    ASSERT_EQ(member.stop(), 0) << member.out();
    ASSERT_EQ(stranger.stop(), 0) << stranger.out();
    for (const std::string& topic : topicsOf(shippedRobot("kurt3d"), true))
        EXPECT_EQ(recordedOn(nothing, topic).size(), 0u) << topic;
    EXPECT_EQ(robot.end(), 0) << robot.out();
}

// Some twenty turns while a station drives it to and fro at 0.1 m/s.
TEST(LongRobotRecording, ScansTakenWhileItDrivesSlowlyFitTheTruth) {
    const TemporaryFolder folder;
    const auto mission = folder / "mission";
    writeText(folder / "hall.yaml", hallFile("hall"));
    const TestDomain domain;
    Truth truth(domain, "hall", "");
    const auto node = nodeIn(domain);
    RobotListener reported(*node, shippedRobot("kurt3d"));
    Recording recording(domain, mission, {"--robot", "kurt3d"});
    RobotProcess robot(domain, "kurt3d", {"--arena", (folder / "hall.yaml").string(), "--seed", "7"});
    ASSERT_TRUE(truth.listener().receives(truth.topic("kurt3d")));
    ASSERT_TRUE(holds(mission, "/kurt3d/points", 24));
    ControlStation station(*node, shippedRobot("kurt3d"));
    station.ask();
    ASSERT_TRUE(waitUntil([&] { return station.mayDrive(); }));
    const auto speed = [&] {
        const auto newest = truth.newest("kurt3d", "kurt3d");
        return newest ? newest->linear.x() : 0.0;
    };
    const auto at = [&] { return truth.newest("kurt3d", "kurt3d")->baseInOdom.translation().x(); };
    // To and fro: the hall is 5 m long, the robot begins at -0.8.
    for (const double towards : {0.1, -0.1, 0.1}) {
        ASSERT_TRUE(station.driveUntil(towards, [&] { return speed() * towards > 0.003; })) << speed();
        const double end = towards > 0.0 ? 0.6 : -0.8;
        ASSERT_TRUE(waitUntil([&] { return towards * (at() - end) > 0.0; }, 90s)) << at();
    }
    station.push(0.0);
    ASSERT_TRUE(waitUntil([&] { return std::abs(speed()) < 0.003; }));
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    for (const std::string reference : {"previous", "map"}) {
        const Registered registered =
            registerAgainst(truth, mission, shippedRobot("kurt3d"), {"--reference", reference});
        EXPECT_THAT(registered.problems, testing::IsEmpty());
        std::printf("driving, against %s: %d scans over %.2f m, worst %.1f mm and %.2f degrees off\n",
                    reference.c_str(), registered.scans, registered.travelled, 1e3 * registered.worstPosition,
                    inDegrees(registered.worstTurn));
        EXPECT_GE(registered.scans, 12);
        EXPECT_GT(registered.travelled, 1.0);
        EXPECT_LT(registered.worstPosition, 0.08);
        EXPECT_LT(registered.worstTurn, degrees(2.0));
    }
}

}  // namespace
}  // namespace leitstand::test
