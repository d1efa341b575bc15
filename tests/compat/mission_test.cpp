// A mission of an earlier program: told, folded, exported, reported and replayed as that program did, and
// gone on with.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/handin/writing/report_folder.h"
#include "app/services/log/live_mission.h"
#include "app/services/log/mission_robots.h"
#include "app/services/log/replay/bag_history.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/settings/comparison_file.h"
#include "core/mission/state/checkpoint/checkpoint.h"
#include "core/mission/state/find_state.h"
#include "tests/compat/expected.h"
#include "tests/compat/lines.h"
#include "tests/compat/state_text.h"
#include "tests/support/dds/test_domain.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Each test on a copy of a mission.
class CompatMission : public testing::TestWithParam<std::string> {
protected:
    CompatMission() {
        setenv("TZ", "UTC", 1);
        fs::copy(compatFile(GetParam()), m_mission, fs::copy_options::recursive);
    }
    [[nodiscard]] static std::string expected(const std::string& name) {
        return GetParam() + "-expected/" + name;
    }

    /// What `leitstandctl` prints.
    [[nodiscard]] static std::string run(const std::vector<std::string>& arguments) {
        const ProcessOutcome outcome = runProcess(program("leitstandctl"), arguments);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return outcome.out;
    }
    [[nodiscard]] std::string exported(const std::string& name) const {
        (void)run({"export", m_mission.string(), "--out", (m_folder / name).string()});
        return readText(m_folder / name);
    }
    [[nodiscard]] std::vector<RobotDescription> robots() const {
        std::vector<std::string> warnings;
        auto kept = keptRobots(m_mission, warnings);
        EXPECT_THAT(warnings, testing::IsEmpty());
        return kept;
    }
    [[nodiscard]] static std::string textOf(const MissionState& state) {
        std::string text;
        for (const std::string& line : stateText(state)) text += line + '\n';
        return text;
    }
    /// The content of each file that is there now, but of the list of all sessions.
    [[nodiscard]] std::map<std::string, std::string> files() const {
        std::map<std::string, std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(m_mission)) {
            if (entry.is_regular_file() && entry.path().filename() != "metadata.yaml")
                found[entry.path().lexically_relative(m_mission).string()] = readText(entry.path());
        }
        return found;
    }

    const TemporaryFolder m_folder;
    const fs::path m_mission = m_folder / "mission";
};

/// Lines of the state that a new session changes: how many events there were, when the last, and of what.
testing::Matcher<std::string> isOfTheWhole() {
    return testing::AnyOf(testing::StartsWith("sequence "), testing::StartsWith("events "),
                          testing::StartsWith("last."), testing::StartsWith("ownTopics."),
                          testing::StartsWith("sessions.count "));
}

TEST_P(CompatMission, InfoTellsTheSame) {
    EXPECT_TRUE(isAsExpected(expected("info.json"), run({"info", "--json", m_mission.string()})));
}

TEST_P(CompatMission, EventsFoldToTheSameState) {
    const auto bag = BagReader::open(m_mission).value();
    EventDecoder decoder(robots());
    Fold fold;
    BagCursor events = bag->read();
    while (const auto event = events.next()) decoder.decode(*event, [&](const Event& one) { fold.add(one); });
    EXPECT_THAT(decoder.errors(), testing::IsEmpty());
    EXPECT_THAT(bag->problems(), testing::IsEmpty());
    EXPECT_TRUE(isAsExpected(expected("state.txt"), textOf(fold.state())));
}

TEST_P(CompatMission, CheckpointsAreReadAndTellTheSame) {
    const auto bag = BagReader::open(m_mission).value();
    EventDecoder decoder(robots());
    BagHistory history(*bag, decoder);
    BagQuery query;
    query.topics = {std::string(station_topic::Checkpoints)};
    BagCursor events = bag->read(query);
    int checkpoints = 0;
    while (const auto event = events.next()) {
        decoder.decode(*event, [&](const Event& one) {
            const auto state = stateOf(one.sample.get<CheckpointSample>());
            ASSERT_TRUE(state) << "checkpoint " << event->sequence << ": " << state.error().text;
            ++checkpoints;
        });
    }
    EXPECT_GE(checkpoints, 2);
    EXPECT_TRUE(isAsExpected(expected("state.txt"), textOf(stateAt(history, bag->lastSequence()))));
}

TEST_P(CompatMission, CloudsWaysAndListsAreExportedTheSame) {
    EXPECT_TRUE(isAsExpected(expected("cloud.xyz"), exported("cloud.xyz"), 2e-3));
    EXPECT_TRUE(isAsExpected(expected("way.tum"), exported("way.tum"), 1e-6));
    for (const char* list : {"x_victims.csv", "x_qr.csv", "x_pois.csv"})
        EXPECT_TRUE(isAsExpected(expected(list), exported(list))) << list;
    for (const char* cloud : {"cloud.ply", "cloud.pcd"}) EXPECT_GT(exported(cloud).size(), 1000U) << cloud;
}

TEST_P(CompatMission, ListsOfFindsInTheReportAreTheSame) {
    const auto reported = json::parse(
        run({"report", m_mission.string(), "--out", (m_folder / "hand-in").string(), "--no-pdf", "--json"}));
    int lists = 0;
    for (const auto& file : reported.at("files")) {
        const std::string name = file.at("file");
        EXPECT_TRUE(file.at("whole").get<bool>()) << name;
        const bool finds = testing::Matches(testing::EndsWith("_victims.csv"))(name) ||
                           testing::Matches(testing::EndsWith("_qr.csv"))(name) ||
                           testing::Matches(testing::EndsWith("_pois.csv"))(name);
        if (!finds) continue;
        EXPECT_TRUE(isAsExpected(expected("hand-in/" + name), readText(m_folder / "hand-in" / name))) << name;
        ++lists;
    }
    EXPECT_EQ(lists, 3);
}

TEST_P(CompatMission, IsReplayed) {
    const TestDomain domain;
    const std::string reported = run({"replay", m_mission.string(), "--json", "--rate", "10", "--domain",
                                      std::to_string(domain.number()), "--interface", "lo"});
    EXPECT_TRUE(isAsExpected(expected("replay.json"), reported));
}

TEST_P(CompatMission, AnotherSessionGoesOnWithItAndLeavesItsFiles) {
    const auto before = files();
    const std::uint64_t last = BagReader::open(m_mission).value()->lastSequence();
    const std::size_t sessions = BagReader::open(m_mission).value()->sessions().size();
    {
        LiveMissionSettings settings;
        settings.folder = m_mission;
        settings.robots = robots();
        const auto mission = LiveMission::open(settings).value();
        const auto resumed = stateText(*mission->state());
        EXPECT_THAT(goneFrom(expected("state.txt"), resumed), testing::Each(isOfTheWhole()));
        ASSERT_TRUE(mission->record(NoteSample{Time(std::chrono::seconds(1'800'000'000)), "a", "", "gone on"},
                                    station_topic::Notes));
        ASSERT_TRUE(mission->close());
    }
    for (const auto& [name, content] : before)
        EXPECT_TRUE(files().at(name) == content) << name << " was changed";
    const auto bag = BagReader::open(m_mission).value();
    EXPECT_EQ(bag->sessions().size(), sessions + 1);
    EXPECT_EQ(bag->sessions().back().firstSequence, last + 1);
    EXPECT_THAT(bag->problems(), testing::IsEmpty());
    EventDecoder decoder(robots());
    BagHistory history(*bag, decoder);
    const MissionState state = stateAt(history, bag->lastSequence());
    EXPECT_EQ(state.notes->back().sample.text, "gone on");
    EXPECT_GT(state.finds->size(), 3U);
}

TEST_P(CompatMission, CheckpointsOfEarlierVersionsAreRead) {
    const auto bag = BagReader::open(m_mission).value();
    BagQuery query;
    query.topics = {std::string(station_topic::Checkpoints)};
    BagCursor cursor = bag->read(query);
    int read = 0;
    while (const auto raw = cursor.next()) {
        const auto event = decodeStationEvent(*raw);
        ASSERT_TRUE(event) << event.error().text;
        const auto& checkpoint = event->sample.get<CheckpointSample>();
        EXPECT_LE(checkpoint.version, CheckpointVersion);
        const auto state = stateOf(checkpoint);
        EXPECT_TRUE(state.ok()) << "version " << checkpoint.version << ": "
                                << (state.ok() ? std::string() : state.error().text);
        ++read;
    }
    EXPECT_GT(read, 0);
}

TEST_P(CompatMission, WhatStandsBesideTheLogIsRead) {
    const auto comparison = readComparison(m_mission / "comparison.yaml");
    ASSERT_TRUE(comparison) << comparison.error().text;
    EXPECT_EQ(writeComparison(*comparison), readText(m_mission / "comparison.yaml"));
    EXPECT_EQ(reportFolderOf(m_mission), "/media/usb/hand-in");
}

INSTANTIATE_TEST_SUITE_P(Of, CompatMission, testing::Values("mission-0.2"), [](const auto& info) {
    std::string name = info.param;
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
    return name;
});

}  // namespace
}  // namespace leitstand::test
