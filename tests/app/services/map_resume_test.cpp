#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/base/time.h"
#include "core/event/station_topics.h"
#include "core/io/bag/bag_reader.h"
#include "tests/app/services/mapped_station.h"
#include "tests/support/child_process.h"
#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

constexpr int Scans = 1'000, Closures = 200;
/// The process of this test that is told the folder is the station that is killed.
constexpr const char* FolderTold = "LEITSTAND_RESUMED_FOLDER";

/// Twice around, half a metre a scan.
Pose truePose(int scan) {
    constexpr double Turn = 4.0 * M_PI / Scans, Radius = 0.5 / Turn;
    const double angle = Turn * scan;
    return poseFrom({Radius * std::sin(angle), Radius * (1.0 - std::cos(angle)), 0.9}, 0, 0, angle);
}

Link linkOf(std::uint64_t id, int from, int to, LinkKind kind, const Pose& error) {
    Link link;
    link.id = id;
    link.from = static_cast<std::uint64_t>(from + 1);
    link.to = static_cast<std::uint64_t>(to + 1);
    link.pose = truePose(from).inverse() * truePose(to) * error;
    link.kind = kind;
    link.information = 1e4 * Information::Identity();
    link.station = "us";
    return link;
}

/// The log of a map of many scans that drifted, in which loops closed and ended before their poses came.
class MapResumeLong : public StationMappingTest {
protected:
    /// @p rows, @p columns: of its scans.
    void write(int rows, int columns) {
        LiveMissionSettings settings;
        settings.folder = m_folder / "mission";
        settings.robots = {kurt()};
        settings.station = "us";
        auto opened = LiveMission::open(settings);
        ASSERT_TRUE(opened.ok()) << opened.error().text;
        LiveMission& mission = **opened;
        RoomSettings room;
        room.sweep = Sweep::Yawing;
        room.rows = rows;
        room.columns = columns;
        Scan seen = scanRoom(room).scan;
        seen.robot = "kurt3d";
        const Pose drift = poseFrom({0.002, 0, 0}, 0, 0, degrees(0.02));
        Pose pose = truePose(0).inverse() * truePose(0);
        std::vector<Pose> poses;
        std::uint64_t links = 0;
        for (int i = 0; i < Scans; ++i) {
            KeyScanSample key;
            key.stamp = Time(1'700'000'000s) + i * 1s;
            key.id = static_cast<std::uint64_t>(i + 1);
            seen.start = key.stamp - 1s;
            seen.end = key.stamp;
            ScanLinksSample registered{key.stamp, "us", {}};
            if (i > 0) {
                registered.links = {linkOf(++links, i - 1, i, LinkKind::Match, drift)};
                pose = pose * registered.links.front().pose;
                key.matched = key.id - 1;
            }
            seen.sensorInOdom = pose;
            seen.hasOdometry = true;
            key.scan = std::make_shared<const Scan>(seen);
            key.sensorInBase = poseFrom({0, 0, 0.9}, 0, 0, 0);
            key.scanInMap = pose;
            ASSERT_TRUE(mission.record(key, station_topic::KeyScans));
            if (i > 0) {
                ASSERT_TRUE(mission.record(registered, station_topic::ScanLinks));
            }
            ScanPose entered;
            entered.scan = key.id;
            entered.scanInMap = pose;
            ASSERT_TRUE(mission.record(
                ScanPosesSample{key.stamp, "us", ScanPosesSample::Cause::Registration, {entered}},
                station_topic::ScanPoses));
        }
        for (int i = 0; i < Closures; ++i) {
            const int first = i * (Scans / 2 - 1) / Closures;
            const ScanLinksSample loop{
                Time(1'700'002'000s),
                "us",
                {linkOf(++links, first, first + Scans / 2, LinkKind::Loop, Pose::Identity()),
                 linkOf(++links, first + 1, first + 1 + Scans / 2, LinkKind::Loop, Pose::Identity())}};
            ASSERT_TRUE(mission.record(loop, station_topic::ScanLinks));
        }
        ASSERT_TRUE(mission.close());
    }
    void becomesCalm() {
        const auto calm = std::make_shared<std::promise<void>>();
        m_mapping->whenCalm([calm] { calm->set_value(); });
        ASSERT_EQ(calm->get_future().wait_for(60s), std::future_status::ready);
    }
    /// Whether the log has poses of closed loops.
    [[nodiscard]] bool hasSolved() const {
        const auto bag = BagReader::open(m_folder / "mission");
        if (!bag) return false;
        BagQuery query;
        query.topics = {std::string(station_topic::ScanPoses)};
        BagCursor cursor = (*bag)->read(query);
        while (const auto event = cursor.next()) {
            const auto decoded = decodeStationEvent(*event);
            const auto* const poses = decoded ? decoded->sample.as<ScanPosesSample>() : nullptr;
            if (poses != nullptr && poses->cause == ScanPosesSample::Cause::LoopClosure) return true;
        }
        return false;
    }
    [[nodiscard]] std::vector<Pose> posesInMap() const {
        std::vector<Pose> poses;
        const LiveMapPtr map = m_mapping->scans();
        for (const LiveKeyScan& scan : map->scans) poses.push_back(scan.pose.scanInMap);
        return poses;
    }
};

TEST_F(MapResumeLong, AThousandScansAnd200ClosuresAreBackInFiveSeconds) {
    ASSERT_NO_FATAL_FAILURE(write(361, 81));
    begin();
    becomesCalm();
    const std::vector<Pose> solved = posesInMap();
    ASSERT_EQ(solved.size(), std::size_t{Scans});
    EXPECT_LT(distanceBetween(solved[Scans / 2], solved[0]), 0.2) << "the laps lie on each other";
    end();
    const SteadyTime began = steadyNow();
    begin();
    ASSERT_TRUE(waitUntil([&] { return m_mapping->scans()->scans.size() == std::size_t{Scans}; }, 60s));
    const double took = secondsBetween(began, steadyNow());
    std::printf("1,000 key scans of 29,241 points and 200 closures are back after %.1f s\n", took);
    EXPECT_LT(took, 5.0);
    becomesCalm();
    const std::vector<Pose> after = posesInMap();
    for (std::size_t i = 0; i < solved.size(); ++i) EXPECT_TRUE(after[i].isApprox(solved[i], 1e-9)) << i;
}

TEST_F(MapResumeLong, WhatIsKilledWhileItSolvesComesToTheSameMap) {
    if (const char* const folder = std::getenv(FolderTold)) {
        fs::create_directory_symlink(folder, m_folder / "mission");
        ASSERT_NO_FATAL_FAILURE(begin());
        std::puts("began");
        std::fflush(stdout);
        becomesCalm();
        std::this_thread::sleep_for(1min);
        return;
    }
    ASSERT_NO_FATAL_FAILURE(write(61, 41));
    const fs::path unsolved = m_folder / "unsolved";
    fs::copy(m_folder / "mission", unsolved, fs::copy_options::recursive);
    begin();
    becomesCalm();
    const std::vector<Pose> whole = posesInMap();
    end();
    ASSERT_EQ(whole.size(), std::size_t{Scans});
    int before = 0;
    for (const int wait : {0, 5, 10, 20, 40, 80, 160, 3'000}) {
        fs::remove_all(m_folder / "mission");
        fs::copy(unsolved, m_folder / "mission", fs::copy_options::recursive);
        {
            ChildProcess station(fs::read_symlink("/proc/self/exe"),
                                 {"--gtest_filter=MapResumeLong.WhatIsKilledWhileItSolvesComesToTheSameMap"},
                                 {std::string(FolderTold) + "=" + (m_folder / "mission").string()});
            ASSERT_TRUE(waitUntil([&] { return station.out().find("began") != std::string::npos; }, 60s))
                << station.out();
            std::this_thread::sleep_for(std::chrono::milliseconds(wait));
            station.signal(SIGKILL);
        }
        before += hasSolved() ? 0 : 1;
        begin();
        becomesCalm();
        const std::vector<Pose> after = posesInMap();
        ASSERT_EQ(after.size(), whole.size());
        for (std::size_t i = 0; i < whole.size(); ++i)
            ASSERT_TRUE(after[i].isApprox(whole[i], 1e-9)) << i << ", killed after " << wait << " ms";
        end();
    }
    std::printf("%d of 8 were killed before the log had what was solved\n", before);
    EXPECT_GE(before, 1);
    EXPECT_LT(before, 8) << "none of them ever solved it";
}

}  // namespace
}  // namespace leitstand::test
