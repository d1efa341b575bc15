#include <csignal>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "tests/app/robots/robot_process.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;

RobotDescription renamed(const std::string& kind, const std::string& name) {
    RobotDescription robot = shippedRobot(kind);
    for (StreamDescription& stream : robot.streams) {
        const std::string before = "/" + robot.name + "/";
        if (stream.topic.starts_with(before))
            stream.topic = "/" + name + "/" + stream.topic.substr(before.size());
        if (stream.role == StreamRole::Diagnostics) stream.hardwareId = name;
    }
    robot.name = name;
    return robot;
}

bool knows(const Node& node, const std::string& name) {
    for (const RemoteParticipant& one : node.participants()) {
        if (one.name == name) return true;
    }
    return false;
}

TEST(RobotProcesses, InterruptedOneLeavesInOrderAndKilledOneLeavesTheOther) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    RobotListener crawlerSaid(*node, shippedRobot("crawler")), kurt3dSaid(*node, shippedRobot("kurt3d"));
    RobotProcess kurt3d(domain, "kurt3d", {"--seed", "7"}), crawler(domain, "crawler", {"--seed", "7"});
    ASSERT_TRUE(crawlerSaid.receives("/crawler/odom", 20) && kurt3dSaid.receives("/kurt3d/odom", 20));
    ASSERT_TRUE(waitUntil([&] { return knows(*node, "crawler") && knows(*node, "kurt3d"); }));

    EXPECT_EQ(kurt3d.end(SIGKILL), -1);
    const auto received = crawlerSaid.count("/crawler/odom"), scans = crawlerSaid.count("/crawler/scan");
    EXPECT_TRUE(crawlerSaid.receives("/crawler/odom", received + 40));
    EXPECT_TRUE(crawlerSaid.receives("/crawler/scan", scans + 15));
    EXPECT_TRUE(knows(*node, "kurt3d")) << "nobody was told that it ended";

    EXPECT_EQ(crawler.end(SIGINT), 0);
    EXPECT_TRUE(waitUntil([&] { return !knows(*node, "crawler"); })) << "it said that it ended";
    EXPECT_THAT(crawlerSaid.errors(), testing::IsEmpty());
    EXPECT_THAT(kurt3dSaid.errors(), testing::IsEmpty());
    EXPECT_EQ(RobotProcess(domain, "crawler").end(SIGTERM), 0);
}

TEST(RobotProcesses, TwoOfAKindHaveNamesOfTheirOwn) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    RobotListener first(*node, renamed("crawler", "alpha")), second(*node, renamed("crawler", "beta"));
    RobotListener nobody(*node, shippedRobot("crawler"));
    RobotProcess alpha(domain, "crawler", {"--name", "alpha"}), beta(domain, "crawler", {"--name", "beta"});
    EXPECT_THAT(beta.out(), HasSubstr("beta is in yellow 1"));
    ASSERT_TRUE(first.receives("/alpha/scan", 3) && second.receives("/beta/scan", 3));
    ASSERT_TRUE(first.receives("/diagnostics", 2) && second.receives("/diagnostics", 2));
    const auto ofBeta = [&] {
        for (const auto& sample : second.all<DiagnosticsSample>("/diagnostics")) {
            if (!sample.statuses.empty()) return true;
        }
        return false;
    };
    EXPECT_TRUE(waitUntil(ofBeta)) << "statuses with hardware_id beta";
    EXPECT_EQ(nobody.count("/crawler/scan"), 0u);
    EXPECT_EQ(first.all<OdometrySample>("/alpha/odom").size() > 0, true);
    EXPECT_EQ(alpha.end(), 0);
    EXPECT_EQ(beta.end(), 0);
}

TEST(RobotProcesses, AGeneratedArenaIsWrittenReadBackAndDrivenIn) {
    const TemporaryFolder folder;
    const auto file = folder / "arena.yaml";
    const auto written =
        runProcess(program("leitstand-robot"), {"arena", "orange", "--seed", "12", "--out", file.string()});
    ASSERT_EQ(written.exitCode, 0) << written.err;
    const auto again = folder / "again.yaml", other = folder / "other.yaml";
    ASSERT_EQ(
        runProcess(program("leitstand-robot"), {"arena", "orange", "--seed", "12", "--out", again.string()})
            .exitCode,
        0);
    ASSERT_EQ(
        runProcess(program("leitstand-robot"), {"arena", "orange", "--seed", "13", "--out", other.string()})
            .exitCode,
        0);
    EXPECT_EQ(readText(file), readText(again));
    EXPECT_NE(readText(file), readText(other)) << "another seed rearranges everything";

    // One reads it, the other generates it: both are in the same world.
    const TestDomain domain;
    Truth truth(domain, "orange_12", "");
    RobotProcess kurt3d(domain, "kurt3d", {"--arena", file.string(), "--seed", "5"});
    RobotProcess crawler(domain, "crawler", {"--arena", "orange", "--seed", "12"});
    EXPECT_THAT(kurt3d.out(), HasSubstr("kurt3d is in orange 12"));
    EXPECT_TRUE(truth.listener().receives(truth.topic("kurt3d")));
    EXPECT_TRUE(truth.listener().receives(truth.topic("crawler")));
}

struct Wrong {
    std::vector<std::string> arguments;
    int exitCode;
    std::string reported;
};

TEST(RobotProcesses, WrongArgumentsAreToldAndNothingRuns) {
    const TemporaryFolder folder;
    writeText(folder / "broken.yaml",
              "name: broken\nfrom: [0, 0]\nto: [6, 2]\nelements:\n  - {kind: dragon, position: [0, 0, 0]}\n");
    writeText(folder / "empty.yaml", "name: empty\nfrom: [0, 0]\nto: [6, 2]\n");
    const std::string broken = (folder / "broken.yaml").string(), empty = (folder / "empty.yaml").string();
    const std::vector<Wrong> all = {
        {{}, 2, "subcommand is required"},
        {{"dragon"}, 2, "subcommand is required"},
        {{"kurt3d", "--domain", "133"}, 2, "--domain"},
        {{"kurt3d", "--seed", "seven"}, 2, "--seed"},
        {{"kurt3d", "--turning-laser"}, 2, "--turning-laser"},
        {{"crawler", "--tilting"}, 2, "--tilting"},
        {{"arena", "yellow"}, 2, "--out"},
        {{"kurt3d", "--robot", "dragon"}, 1, "dragon"},
        {{"kurt3d", "--arena", "blue"},
         1,
         "blue: cannot be opened; expected yellow, orange, red, building or an arena"},
        {{"kurt3d", "--arena", broken}, 1, "broken.yaml:5"},
        {{"kurt3d", "--arena", empty}, 1, "expected a start of kurt3d"},
        {{"kurt3d", "--name", "A/b"}, 1, "--name"},
        {{"kurt3d", "--interface", "none9"}, 1, "none9"},
        {{"kurt3d", "--keys", (folder / "none").string()}, 1, (folder / "none").string()},
        {{"arena", "blue", "--out", (folder / "x.yaml").string()},
         1,
         "expected yellow, orange, red or building"},
        {{"arena", "yellow", "--out", (folder / "none" / "x.yaml").string()}, 1, "cannot be written"},
    };
    for (const Wrong& wrong : all) {
        const auto outcome = runProcess(program("leitstand-robot"), wrong.arguments);
        EXPECT_EQ(outcome.exitCode, wrong.exitCode) << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(wrong.reported));
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_EQ(runProcess(program("leitstand-robot"), {"--help"}).exitCode, 0);
}

TEST(RobotProcesses, TheCrawlersTurningLaserGivesSlices) {
    const TestDomain domain;
    const auto node = nodeIn(domain);
    RobotListener reported(*node, shippedRobot("crawler"));
    RobotProcess crawler(domain, "crawler", {"--seed", "7", "--turning-laser"});
    ASSERT_TRUE(reported.receives("/crawler/points", 4) && reported.receives("/crawler/scan", 10));
    const auto slices = reported.all<CloudSample>("/crawler/points");
    for (const CloudSample& slice : slices) {
        EXPECT_EQ(slice.columns, 445);
        EXPECT_EQ(slice.header.frame, "laser");
    }
    // Raw scans turn: their frame is told in tf.
    EXPECT_EQ(reported.all<RangesSample>("/crawler/scan").front().header.frame, "laser_fan");
    const auto fan = [&] {
        for (const auto& transforms : reported.all<TransformsSample>("/crawler/tf")) {
            for (const FrameTransform& one : transforms.transforms) {
                if (one.childFrame == "laser_fan") return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(waitUntil(fan));
    EXPECT_THAT(reported.errors(), testing::IsEmpty());
}

/// The robot's shipped file with @p words added to its sensor @p sensor.
std::string fileWith(const std::string& robot, const std::string& sensor, const std::string& words) {
    std::string text = readText(sourceFolder() + "/resources/robots/" + robot + ".yaml");
    const std::string begin = "  " + sensor + ": {";
    const auto at = text.find(begin);
    if (at == std::string::npos) throw std::runtime_error(robot + ".yaml has no " + sensor);
    return text.insert(at + begin.size(), words + ", ");
}

TEST(RobotProcesses, TheRobotsFileSaysWhatItCarries) {
    const TemporaryFolder folder;
    writeText(folder / "tilting.yaml", fileWith("kurt3d", "scanner", "motion: tilting"));
    writeText(folder / "turning.yaml", fileWith("crawler", "laser", "motion: turning"));
    const TestDomain domain;
    const auto node = nodeIn(domain);
    RobotListener kurt3dSaid(*node, shippedRobot("kurt3d")), crawlerSaid(*node, shippedRobot("crawler"));
    RobotProcess kurt3d(domain, "kurt3d", {"--robot", (folder / "tilting.yaml").string()});
    RobotProcess crawler(domain, "crawler", {"--robot", (folder / "turning.yaml").string()});
    ASSERT_TRUE(kurt3dSaid.receives("/kurt3d/points") && crawlerSaid.receives("/crawler/points"));
    const auto sweep = kurt3dSaid.all<CloudSample>("/kurt3d/points").front();
    EXPECT_EQ(sweep.rows, 241);
    EXPECT_EQ(sweep.columns, 181);
    EXPECT_EQ(crawlerSaid.all<CloudSample>("/crawler/points").front().columns, 445);
}

}  // namespace
}  // namespace leitstand::test
