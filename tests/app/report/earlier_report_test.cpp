// What a report leaves of earlier ones in its folder.
#include <chrono>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/writing/report_writer.h"
#include "app/services/log/live_mission.h"
#include "core/event/sample.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/io/handin/checksums.h"
#include "core/io/robot/robot_file.h"
#include "core/io/robot/shipped_robots.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wait.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::Each;
using testing::IsSupersetOf;
using testing::Not;
using testing::StartsWith;

constexpr const char* Unnamed = "Competition-Team-run";
constexpr const char* Named = "RoboCup2013-Deutschland1-Final_1";

/// A mission without a map, which nobody has named, and its first report.
class EarlierReportTest : public testing::Test {
protected:
    void SetUp() override {
        writeMission("run");
        ASSERT_NO_FATAL_FAILURE(report("run"));
        ASSERT_THAT(files(),
                    IsSupersetOf({std::string(Unnamed) + "_pois.csv", std::string(Unnamed) + "_qr.csv",
                                  std::string(Unnamed) + "_victims.csv"}));
    }
    void writeMission(const char* name) const {
        writeSampleMission(m_folder / name, {.scans = 0, .odometry = 2, .finds = false, .info = false});
    }
    /// Its station goes on, and the operator fills in what it is.
    void nameIt() const {
        LiveMissionSettings settings;
        settings.folder = m_folder / "run";
        const auto file = findRobotFile("kurt3d");
        ASSERT_TRUE(file) << file.error().text;
        const auto robot = readRobot(*file);
        ASSERT_TRUE(robot) << robot.error().text;
        settings.robots = {*robot};
        auto mission = LiveMission::open(settings);
        ASSERT_TRUE(mission) << mission.error().text;
        MissionInfoSample info;
        info.competition = "RoboCup2013";
        info.team = "Deutschland1";
        info.mission = "Final 1";
        ASSERT_TRUE((*mission)->record(info, station_topic::Mission));
        ASSERT_TRUE((*mission)->close());
    }
    void report(const char* mission, const ReportOptions& options = {}) const {
        const auto done = writeReport(m_folder / mission, m_out, options);
        ASSERT_TRUE(done) << done.error().text;
    }
    [[nodiscard]] std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(m_out))
            names.insert(entry.path().filename().string());
        return names;
    }
    [[nodiscard]] fs::path unnamed(const char* ending) const {
        return m_out / (std::string(Unnamed) + ending);
    }

    const TemporaryFolder m_folder;
    const fs::path m_out = m_folder / "out";
};

TEST_F(EarlierReportTest, ItsFilesGoWhenTheMissionGetsItsName) {
    writeText(m_out / "notes.txt", "by hand");
    writeText(m_out / (std::string(Unnamed) + "_sketch.txt"), "by hand, named alike");
    ASSERT_NO_FATAL_FAILURE(nameIt());
    ASSERT_NO_FATAL_FAILURE(report("run"));
    auto left = files();
    EXPECT_EQ(left.erase("notes.txt"), 1U) << "no report listed it";
    EXPECT_EQ(left.erase(std::string(Unnamed) + "_sketch.txt"), 1U);
    EXPECT_EQ(left.erase("SHA256SUMS"), 1U);
    EXPECT_THAT(left, Each(StartsWith(Named)));
    const auto listed = checkChecksums(m_out);
    ASSERT_TRUE(listed) << listed.error().text;
    EXPECT_EQ(std::set<std::string>(listed->begin(), listed->end()), left);
}

TEST_F(EarlierReportTest, AFileThatWasChangedSinceStays) {
    writeText(unnamed("_qr.csv"), "corrected by hand");
    ASSERT_NO_FATAL_FAILURE(nameIt());
    ASSERT_NO_FATAL_FAILURE(report("run"));
    EXPECT_EQ(readText(unnamed("_qr.csv")), "corrected by hand");
    EXPECT_FALSE(fs::exists(unnamed("_pois.csv")));
}

TEST_F(EarlierReportTest, ALinkStaysAndWhatItLeadsToAsWell) {
    fs::rename(unnamed("_pois.csv"), m_folder / "elsewhere_pois.csv");
    fs::create_symlink(m_folder / "elsewhere_pois.csv", unnamed("_pois.csv"));
    ASSERT_NO_FATAL_FAILURE(nameIt());
    ASSERT_NO_FATAL_FAILURE(report("run"));
    EXPECT_TRUE(fs::exists(m_folder / "elsewhere_pois.csv"));
    EXPECT_TRUE(fs::is_symlink(unnamed("_pois.csv")));
    EXPECT_FALSE(fs::exists(unnamed("_qr.csv")));
}

TEST_F(EarlierReportTest, AListThatLeadsOutOfItsFolderRemovesNothing) {
    const fs::path precious = m_folder / (std::string(Unnamed) + "_precious.csv");
    writeText(precious, "dear");
    const auto sum = sha256Of(precious);
    ASSERT_TRUE(sum) << sum.error().text;
    writeText(m_out / "SHA256SUMS", readText(m_out / "SHA256SUMS") + *sum + "  ../" +
                                        precious.filename().string() + "\n" + *sum + "  ..\n");
    ASSERT_NO_FATAL_FAILURE(nameIt());
    ASSERT_NO_FATAL_FAILURE(report("run"));
    EXPECT_EQ(readText(precious), "dear");
    EXPECT_TRUE(fs::exists(unnamed("_pois.csv"))) << "a list that is not ours says nothing";
}

TEST_F(EarlierReportTest, TheReportOfAnotherMissionStays) {
    const auto before = files();
    const auto second = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
    ASSERT_TRUE(waitUntil([&] {
        return std::chrono::system_clock::now() >= second + std::chrono::seconds(1);
    })) << "missions are told apart by the second in which they began";
    writeMission("run_2");
    ASSERT_NO_FATAL_FAILURE(report("run_2"));
    EXPECT_THAT(files(), IsSupersetOf(before));
    EXPECT_THAT(files(), Contains(std::string(Unnamed) + "_2_pois.csv"));
}

TEST_F(EarlierReportTest, WhatTheNewReportLacksGoesUnderTheSameNameToo) {
    ReportOptions pages;
    pages.pdf = [](const ReportContent&) -> Result<std::string> { return std::string("pages"); };
    ASSERT_NO_FATAL_FAILURE(report("run", pages));
    ASSERT_TRUE(fs::exists(unnamed(".pdf")));
    ASSERT_NO_FATAL_FAILURE(report("run"));
    EXPECT_FALSE(fs::exists(unnamed(".pdf"))) << "it is of an earlier state of the mission";
    EXPECT_TRUE(fs::exists(unnamed("_pois.csv")));
}

TEST_F(EarlierReportTest, AReportThatFailsTakesNothingAway) {
    const auto before = files();
    fs::create_directory(m_out / (std::string(Named) + "_pois.csv"));
    ASSERT_NO_FATAL_FAILURE(nameIt());
    EXPECT_FALSE(writeReport(m_folder / "run", m_out, {}));
    EXPECT_THAT(files(), IsSupersetOf(before));
    const auto listed = checkChecksums(m_out);
    ASSERT_TRUE(listed) << listed.error().text;
    EXPECT_THAT(*listed, Contains(std::string(Unnamed) + "_pois.csv")) << "whatever is there is listed";
    fs::remove(m_out / (std::string(Named) + "_pois.csv"));
    ASSERT_NO_FATAL_FAILURE(report("run"));
    EXPECT_THAT(files(), Not(Contains(StartsWith(Unnamed)))) << "the next one that succeeds does";
}

}  // namespace
}  // namespace leitstand::test
