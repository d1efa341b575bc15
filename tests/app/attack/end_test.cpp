#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "core/io/bag/bag_writer.h"
#include "core/io/robot/robot_file.h"
#include "tests/app/recording.h"
#include "tests/support/hanging_library.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// A mission with a sample of @p topic every 20 ms for half a minute.
void writeMission(const std::filesystem::path& mission, const std::string& topic) {
    const auto writer = must(BagWriter::open(mission));
    writer->addTopic({.name = topic, .type = TestType});
    for (std::uint64_t i = 1; i <= 1'500; ++i) {
        writer->write({i, Time(1'767'225'600s + i * 20ms), topic, TestType,
                       testPayload(12, static_cast<std::uint32_t>(i))});
    }
    ASSERT_TRUE(writer->close());
}

// Leaving the domain waits for the library's threads for ever, and would keep the log open.
TEST(End, ARecorderWhoseLibraryHangsEndsWithinFiveSecondsAndItsLogIsWhole) {
    const TestDomain domain;
    const TemporaryFolder folder;
    const std::string number = std::to_string(domain.number());
    const ChildProcess robot(program("leitstand-robot"), {"kurt3d", "--arena", "yellow", "--seed", "7",
                                                          "--domain", number, "--interface", "lo"});
    ChildProcess recorder(program("leitstandctl"),
                          {"record", "--out", (folder / "mission").string(), "--robot", "kurt3d", "--domain",
                           number, "--interface", "lo"});
    ASSERT_TRUE(waitUntil([&] { return recordedOn(folder / "mission", "/kurt3d/odom").size() > 20; }, 60s))
        << recorder.out();
    HangingLibrary hanging(recorder.id());
    ASSERT_GT(hanging.threads(), 1U);
    recorder.signal(SIGTERM);
    EXPECT_TRUE(hanging.endsWithin(5s)) << recorder.out();
    EXPECT_EQ(recorder.wait(), 1);
    EXPECT_NE(recorder.out().find("events,"), std::string::npos) << recorder.out();  // the summary
    const auto bag = must(BagReader::open(folder / "mission"));
    EXPECT_TRUE(bag->problems().empty());
    for (const auto& file : std::filesystem::directory_iterator(folder / "mission"))
        EXPECT_FALSE(file.path().string().ends_with("-wal")) << file.path();
}

TEST(End, AReplayWhoseLibraryHangsEndsWithinFiveSecondsAndItsSummaryIsWhole) {
    const TestDomain domain;
    const TemporaryFolder folder;
    ASSERT_NO_FATAL_FAILURE(writeMission(folder / "mission", "/kurt3d/x"));
    Inbox inbox;
    const auto node = nodeIn(domain);
    const auto listening = must(node->subscribe({"/kurt3d/x", TestType, reliable(100)}, inbox.callback()));
    ChildProcess replay(program("leitstandctl"), {"replay", (folder / "mission").string(), "--json",
                                                  "--domain", std::to_string(domain.number())});
    ASSERT_TRUE(inbox.waitFor(20, 60s)) << replay.out();
    HangingLibrary hanging(replay.id());
    ASSERT_GT(hanging.threads(), 1U);
    replay.signal(SIGTERM);
    EXPECT_TRUE(hanging.endsWithin(5s)) << replay.out();
    EXPECT_EQ(replay.wait(), 1);
    EXPECT_NE(replay.out().find("\"problems\": []\n}\n"), std::string::npos) << replay.out();
}

TEST(End, AProbeWhoseLibraryHangsEndsWithinFiveSecondsAndAllThatItWritesIsWhole) {
    const TestDomain domain;
    const TemporaryFolder folder;
    const auto node = nodeIn(domain);
    const auto publisher =
        must(node->publisher({.topic = "/kurt3d/odom", .type = "nav_msgs/msg/Odometry", .qos = reliable(5)}));
    ChildProcess probe(program("leitstandctl"),
                       {"probe", "--json", "--seconds", "600", "--out", folder.path().string(), "--domain",
                        std::to_string(domain.number())});
    const auto listens = [&] {
        const auto endpoints = node->endpoints();
        return std::any_of(endpoints.begin(), endpoints.end(), [](const RemoteEndpoint& one) {
            return one.kind == RemoteEndpoint::Kind::Reader && one.topic == "/kurt3d/odom";
        });
    };
    ASSERT_TRUE(waitUntil(listens, 60s)) << probe.out();
    HangingLibrary hanging(probe.id());
    ASSERT_GT(hanging.threads(), 1U);
    probe.signal(SIGTERM);
    EXPECT_TRUE(hanging.endsWithin(5s)) << probe.out();
    EXPECT_EQ(probe.wait(), 1);
    EXPECT_NE(probe.out().find("\"warnings\": []\n}\n"), std::string::npos) << probe.out();
    const auto robot = readRobot(folder / "kurt3d.yaml");
    ASSERT_TRUE(robot.ok()) << robot.error().text;
    EXPECT_EQ(robot->streams.size(), 1U);
}

TEST(End, ARobotWhoseLibraryHangsEndsWithinFiveSeconds) {
    const TestDomain domain;
    ChildProcess robot(program("leitstand-robot"), {"kurt3d", "--arena", "yellow", "--seed", "7", "--domain",
                                                    std::to_string(domain.number()), "--interface", "lo"});
    ASSERT_TRUE(waitUntil([&] { return robot.out().find("is in") != std::string::npos; }, 60s))
        << robot.out();
    HangingLibrary hanging(robot.id());
    ASSERT_GT(hanging.threads(), 1U);
    robot.signal(SIGTERM);
    EXPECT_TRUE(hanging.endsWithin(5s));
    EXPECT_NE(robot.wait(), 0);
}

}  // namespace
}  // namespace leitstand::test
