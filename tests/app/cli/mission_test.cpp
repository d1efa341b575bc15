#include <csignal>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "core/event/raw_event.h"
#include "core/io/bag/bag_reader.h"
#include "tests/app/recording.h"
#include "tests/support/child_process.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/support/shared_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

Eigen::Vector3d positionOf(const json& scan) {
    const auto pose = scan["pose"].get<std::vector<double>>();
    return {pose[3], pose[7], pose[11]};
}

/// A robot that has said all its scans to the recorder.
class Robot {
public:
    Robot(const TestDomain& domain, std::vector<std::string> more = {})
        : m_process(program("leitstand-test-robot"), arguments(domain, std::move(more))) {}
    [[nodiscard]] bool saidAll() {
        return waitUntil([this] { return m_process.out().find("said ") != std::string::npos; },
                         std::chrono::seconds(60));
    }
    [[nodiscard]] std::string out() const { return m_process.out(); }

private:
    static std::vector<std::string> arguments(const TestDomain& domain, std::vector<std::string> more) {
        more.insert(more.begin(), {"--domain", std::to_string(domain.number())});
        return more;
    }
    ChildProcess m_process;
};

/// Records what a robot says, from beginning to end.
void record(const fs::path& mission, const std::vector<std::string>& robot = {},
            const std::vector<std::string>& recorder = {}) {
    const TestDomain domain;
    Recording recording(domain, mission, recorder);
    Robot pending(domain, robot);
    ASSERT_TRUE(pending.saidAll()) << pending.out() << recording.out();
    ASSERT_EQ(recording.stop(), 0) << recording.out();
}

std::size_t messagesOn(const json& info, const std::string& topic) {
    for (const json& one : info["topics"]) {
        if (one["topic"] == topic) return one["messages"].get<std::size_t>();
    }
    return 0;
}

std::vector<std::vector<std::byte>> payloadsOn(const fs::path& mission, const std::string& topic) {
    std::vector<std::vector<std::byte>> payloads;
    for (const Payload& payload : recordedOn(mission, topic)) payloads.push_back(*payload);
    return payloads;
}

TEST(Mission, WhatARobotSaysIsRecordedAndRegistered) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission));
    const auto info = leitstandctl({"info", mission.string(), "--json"});
    ASSERT_EQ(info.exitCode, 0) << info.err;
    const json reported = json::parse(info.out);
    EXPECT_EQ(messagesOn(reported, "/kurt3d/points"), 3u);
    EXPECT_EQ(messagesOn(reported, "/kurt3d/tf_static"), 1u);
    EXPECT_GT(messagesOn(reported, "/kurt3d/odom"), 20u);
    EXPECT_EQ(messagesOn(reported, "/leitstand/sessions"), 2u) << "its beginning and its end";
    EXPECT_GE(messagesOn(reported, "/leitstand/checkpoints"), 1u);
    EXPECT_EQ(reported["problems"].size(), 0u) << info.out;

    const auto run = leitstandctl({"register", mission.string(), "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json scans = json::parse(run.out)["scans"];
    ASSERT_EQ(scans.size(), 3u);
    EXPECT_LT((positionOf(scans[1]) - Eigen::Vector3d(0.4, 0.1, 0.0)).norm(), 0.02) << run.out;
    EXPECT_LT((positionOf(scans[2]) - Eigen::Vector3d(0.8, 0.2, 0.0)).norm(), 0.03) << run.out;
}

TEST(Mission, RecordedIntoMcapItIsAMissionToo) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission, {}, {"--storage", "mcap"}));
    ASSERT_NO_FATAL_FAILURE(record(mission));  // goes on as it began
    const json info = json::parse(leitstandctl({"info", mission.string(), "--json"}).out);
    ASSERT_EQ(info["sessions"].size(), 2u);
    EXPECT_EQ(info["sessions"][0]["file"], "mission_0.mcap");
    EXPECT_EQ(info["sessions"][1]["file"], "mission_1.mcap");
    EXPECT_EQ(info["ours"], true);
    EXPECT_EQ(messagesOn(info, "/kurt3d/points"), 6u);
    EXPECT_EQ(info["problems"].size(), 0u) << info.dump();

    const auto run = leitstandctl({"register", mission.string(), "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    EXPECT_EQ(json::parse(run.out)["scans"].size(), 6u);

    const TestDomain domain;
    const auto refused = leitstandctl({"record", "--out", mission.string(), "--storage", "sqlite3",
                                       "--domain", std::to_string(domain.number())});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr("stored alike"));
}

TEST(Mission, SlicesBecomeTurns) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission, {"--slices", "23"}));
    EXPECT_EQ(payloadsOn(mission, "/kurt3d/points").size(), 69u);
    const auto run = leitstandctl({"register", mission.string(), "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json scans = json::parse(run.out)["scans"];
    ASSERT_EQ(scans.size(), 3u);
    EXPECT_EQ(scans[0]["points"].get<int>(), 181 * 161);
    EXPECT_LT((positionOf(scans[2]) - Eigen::Vector3d(0.8, 0.2, 0.0)).norm(), 0.03) << run.out;
}

TEST(Mission, TheHallComesThroughTheWireAsItIsInItsFiles) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission, {"--scans", hall.string()}));
    const auto wired = leitstandctl({"register", mission.string(), "--json"});
    const auto filed = leitstandctl({"register", hall.string(), "--json"});
    ASSERT_EQ(wired.exitCode, 0) << wired.err;
    const json a = json::parse(wired.out)["scans"], b = json::parse(filed.out)["scans"];
    ASSERT_EQ(a.size(), 3u);
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_EQ(a[i]["points"], b[i]["points"]);
        EXPECT_LT((positionOf(a[i]) - positionOf(b[i])).norm(), 0.01);
    }
}

TEST(Mission, ResumingWritesANewSessionAndLeavesTheOldOneAlone) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission));
    const auto before = json::parse(leitstandctl({"info", mission.string(), "--json"}).out);
    const fs::path first = mission / before["sessions"][0]["file"].get<std::string>();
    const auto size = fs::file_size(first);
    const auto written = fs::last_write_time(first);
    ASSERT_NO_FATAL_FAILURE(record(mission));
    EXPECT_EQ(fs::file_size(first), size);
    EXPECT_EQ(fs::last_write_time(first), written);
    const auto after = json::parse(leitstandctl({"info", mission.string(), "--json"}).out);
    ASSERT_EQ(after["sessions"].size(), 2u);
    EXPECT_EQ(messagesOn(after, "/kurt3d/points"), 6u);
    EXPECT_GT(after["sessions"][1]["first_sequence"], after["sessions"][0]["last_sequence"]);
}

TEST(Mission, InASecuredDomainOnlyMembersAreRecorded) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission", keys = folder / "keys", members = keys / "enclaves";
    const auto made =
        leitstandctl({"keys", "--out", keys.string(), "--station", "station1", "--robot", "kurt3d"});
    ASSERT_EQ(made.exitCode, 0) << made.err;
    const TestDomain domain;
    Recording recording(domain, mission, {"--keys", (members / "station1").string()});
    EXPECT_TRUE(recording.says("Security is on: station1 (station)")) << recording.out();
    Robot stranger(domain, {"--name", "stranger", "--wait-for", "0"});
    Robot member(domain, {"--keys", (members / "kurt3d").string()});
    ASSERT_TRUE(stranger.saidAll() && member.saidAll()) << stranger.out() << member.out() << recording.out();
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    EXPECT_EQ(payloadsOn(mission, "/kurt3d/points").size(), 3u);
    EXPECT_EQ(payloadsOn(mission, "/stranger/points").size(), 0u);
    EXPECT_EQ(payloadsOn(mission, "/stranger/odom").size(), 0u);
}

TEST(Mission, RobotsThatCannotWorkSideBySideAreToldAndNothingIsWritten) {
    const TemporaryFolder folder;
    const auto twice =
        leitstandctl({"record", "--out", (folder / "mission").string(), "--robot", "kurt3d", "kurt3d"});
    EXPECT_EQ(twice.exitCode, 1);
    EXPECT_THAT(twice.err, HasSubstr("two robots are named kurt3d"));
    const auto unknown =
        leitstandctl({"record", "--out", (folder / "mission").string(), "--robot", "kurt4d"});
    EXPECT_EQ(unknown.exitCode, 1);
    EXPECT_THAT(unknown.err,
                HasSubstr("crawler, husky, kurt3d, livox, ouster, tracked, turtlebot or turtlebot4"));
    EXPECT_FALSE(fs::exists(folder / "mission"));
}

TEST(Mission, KeysThatCannotServeAreToldAndNothingIsWritten) {
    const TemporaryFolder folder;
    const auto refused = leitstandctl(
        {"record", "--out", (folder / "mission").string(), "--keys", (folder / "none").string()});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr((folder / "none").string()));
    EXPECT_FALSE(fs::exists(folder / "mission"));
}

TEST(Mission, ALinkThatBreaksIsToldWhileItIsRecorded) {
    const TemporaryFolder folder;
    const TestDomain domain;
    Recording recording(domain, folder / "mission", {"--robot", "kurt3d", "crawler"});
    const auto reported = [&](const std::string& text) {
        return waitUntil([&] { return recording.out().find(text) != std::string::npos; });
    };
    {
        Robot robot(domain);
        EXPECT_TRUE(reported("kurt3d: connected")) << recording.out();
    }
    EXPECT_TRUE(reported("kurt3d: lost: ")) << recording.out();
    Robot again(domain, {"--wait-for", "0"});
    EXPECT_TRUE(waitUntil([&] {
        const std::string out = recording.out();
        return out.find("kurt3d: connected", out.find("kurt3d: lost")) != std::string::npos;
    })) << recording.out();
    EXPECT_EQ(recording.stop(), 0);
}

TEST(Replay, SaysTheSameAgain) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission", again = folder / "again";
    ASSERT_NO_FATAL_FAILURE(record(mission));
    const TestDomain domain;
    Recording recording(domain, again);
    const auto replay = leitstandctl(
        {"replay", mission.string(), "--domain", std::to_string(domain.number()), "--rate", "4", "--json"});
    ASSERT_EQ(replay.exitCode, 0) << replay.err;
    const json outcome = json::parse(replay.out);
    EXPECT_GT(outcome["held_back"], 0) << "the station's own events";
    ASSERT_EQ(recording.stop(), 0) << recording.out();
    EXPECT_EQ(payloadsOn(again, "/kurt3d/points"), payloadsOn(mission, "/kurt3d/points"));
    EXPECT_EQ(payloadsOn(again, "/kurt3d/tf_static"), payloadsOn(mission, "/kurt3d/tf_static"));
}

TEST(Replay, StandsStillWhilePausedAndGoesOnWhereItWas) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission));
    const TestDomain domain;
    ChildProcess replay(program("leitstandctl"), {"replay", mission.string(), "--domain",
                                                  std::to_string(domain.number()), "--loop", "--rate", "2"});
    Recording recording(domain, folder / "heard");
    const auto received = [&] {
        const auto bag = BagReader::open(folder / "heard");
        return bag ? (*bag)->lastSequence() : 0;
    };
    ASSERT_TRUE(waitUntil([&] { return received() > 50; }, std::chrono::seconds(30))) << replay.out();
    replay.signal(SIGUSR1);
    // Once nothing has come for a second and a half, three commits of the log, it stands still.
    std::uint64_t before = 0;
    ASSERT_TRUE(waitUntil(
        [&] {
            const auto now = received();
            std::this_thread::sleep_for(std::chrono::milliseconds(1500));
            return std::exchange(before, now) == now;
        },
        std::chrono::seconds(20)));
    replay.signal(SIGUSR1);
    // It loops: far more comes than the mission holds.
    const auto whole = (*BagReader::open(mission))->lastSequence();
    EXPECT_TRUE(waitUntil([&] { return received() > before + whole; }, std::chrono::seconds(40)))
        << received() << " of " << before + whole;
    replay.signal(SIGINT);
    EXPECT_EQ(replay.wait(), 0) << replay.out();
    EXPECT_EQ(recording.stop(), 0);
}

TEST(Replay, RefusesADomainWhereTheRobotIsLive) {
    const TemporaryFolder folder;
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission));
    const TestDomain domain;
    Robot live(domain, {"--wait-for", "0"});
    ASSERT_TRUE(live.saidAll());
    const auto refused =
        leitstandctl({"replay", mission.string(), "--domain", std::to_string(domain.number())});
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.err, HasSubstr("robot kurt3d is there live"));
}

TEST(Probe, FindsTheRobotAndWritesAFileThatRecordTakes) {
    const TemporaryFolder folder;
    const TestDomain domain;
    Robot robot(domain, {"--wait-for", "0"});
    ASSERT_TRUE(robot.saidAll());
    const auto probe = leitstandctl({"probe", "--domain", std::to_string(domain.number()), "--seconds", "3",
                                     "--out", folder.path().string(), "--json"});
    ASSERT_EQ(probe.exitCode, 0) << probe.err;
    const json report = json::parse(probe.out);
    ASSERT_EQ(report["robots"].size(), 1u) << probe.out;
    EXPECT_EQ(report["robots"][0]["name"], "kurt3d");
    for (const json& topic : report["topics"]) {
        if (topic["topic"] != "/kurt3d/odom") continue;
        EXPECT_EQ(topic["role"], "odometry");
        EXPECT_EQ(topic["qos"], "best effort");
        EXPECT_GT(topic["rate"], 20.0);
    }
    const std::string file = report["robots"][0]["file"].get<std::string>();
    ASSERT_TRUE(fs::exists(file));
    const fs::path mission = folder / "mission";
    ASSERT_NO_FATAL_FAILURE(record(mission, {}, {"--robot", file}));
    EXPECT_EQ(payloadsOn(mission, "/kurt3d/points").size(), 3u);
    EXPECT_TRUE(fs::exists(mission / "robots" / "kurt3d.yaml"));
    EXPECT_GT(payloadsOn(mission, "/leitstand/clock_offsets").size(), 0u);
    const auto again = leitstandctl({"probe", "--domain", std::to_string(domain.number()), "--seconds", "3",
                                     "--out", folder.path().string()});
    EXPECT_THAT(again.err, HasSubstr("stays as it is")) << "a file is never written over";
}

TEST(Probe, AnEmptyDomainIsToldWithWhatToLookAt) {
    const TemporaryFolder folder;
    const TestDomain domain;
    const auto probe = leitstandctl({"probe", "--domain", std::to_string(domain.number()), "--seconds", "1",
                                     "--out", folder.path().string()});
    EXPECT_EQ(probe.exitCode, 0);
    EXPECT_THAT(probe.out, HasSubstr("ROS_DOMAIN_ID"));
}

TEST(Probe, ListensWhereRosOfThisComputerDoes) {
    const TemporaryFolder folder;
    const TestDomain domain;
    const std::string number = std::to_string(domain.number());
    Robot robot(domain, {"--wait-for", "0"});
    ASSERT_TRUE(robot.saidAll());
    const auto probe = [&](const std::string& variable) {
        ChildProcess child(program("leitstandctl"),
                           {"probe", "--seconds", "3", "--out", folder.path().string()}, {variable});
        const int code = child.wait();
        return std::pair(code, child.out());
    };
    const auto [code, out] = probe("ROS_DOMAIN_ID=" + number);
    EXPECT_EQ(code, 0) << out;
    EXPECT_THAT(out, HasSubstr("/kurt3d/odom"));
    EXPECT_THAT(out, HasSubstr("ROS_DOMAIN_ID=" + number));
    const auto [refused, why] = probe("ROS_DOMAIN_ID=arena");
    EXPECT_EQ(refused, 1);
    EXPECT_THAT(why, testing::AllOf(HasSubstr("ROS_DOMAIN_ID"), HasSubstr("\"arena\""), HasSubstr("0..232")));
}

TEST(Info, WhatIsNoMissionIsTold) {
    const TemporaryFolder folder;
    const auto nothing = leitstandctl({"info", (folder / "none").string()});
    EXPECT_EQ(nothing.exitCode, 1);
    EXPECT_THAT(nothing.err, HasSubstr("none"));
    const auto usage = leitstandctl({"info"});
    EXPECT_EQ(usage.exitCode, 2);
}

}  // namespace
}  // namespace leitstand::test
