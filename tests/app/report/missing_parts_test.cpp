// What a report makes of missions that are not whole, and of bags that lack what ours have.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <nlohmann/json.hpp>

#include "core/event/motion_samples.h"
#include "core/io/clouds/tum.h"
#include "core/io/handin/find_lists.h"
#include "core/io/handin/geotiff.h"
#include "tests/app/report/foreign_bag.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A report and what came of it.
class Made {
public:
    Made(const fs::path& mission, const fs::path& out) : m_out(out) {
        const ProcessOutcome made = runProcess(program("leitstandctl"),
                                               {"report", mission.string(), "--out", out.string(), "--json"});
        EXPECT_EQ(made.exitCode, 0) << made.out << made.err;
        reported = made.err;
        if (made.exitCode == 0) json = nlohmann::json::parse(made.out);
        for (const auto& one : json["files"]) EXPECT_TRUE(one["whole"].get<bool>()) << one;
    }
    /// The file that ends so, whatever the report is called.
    [[nodiscard]] fs::path file(const std::string& ending) const {
        return m_out / (json["name"].get<std::string>() + ending);
    }
    [[nodiscard]] bool has(const std::string& ending) const { return fs::exists(file(ending)); }

    std::string reported;
    nlohmann::json json;

private:
    fs::path m_out;
};

void expectNoMap(const Made& report) {
    for (const char* ending : {".tif", "_upper.tif", ".bt", ".ply"})
        EXPECT_FALSE(report.has(ending)) << ending;
    EXPECT_TRUE(report.has(".pdf"));
    EXPECT_THAT(report.reported, HasSubstr("without a map there are no GeoTIFF"));
}

void expectTheFinds(const Made& report) {
    const auto victims = readFindList(report.file("_victims.csv")),
               pois = readFindList(report.file("_pois.csv"));
    ASSERT_TRUE(victims.ok() && pois.ok());
    ASSERT_EQ(victims->finds.size(), 1U);
    EXPECT_EQ(victims->finds[0].position, Eigen::Vector3d(1.5, 1.0, 0.4));
    EXPECT_EQ(pois->finds.size(), 4U);
}

/// A mission of two sessions: the first has the map, the second what was found.
void writeTwoSessions(const fs::path& mission) {
    writeSampleMission(mission, {.finds = false});
    writeSampleMission(mission, {.scans = 0, .odometry = 0, .info = false});
}

TEST(MissingParts, OfTwoSessionsWhoseFirstIsLostTheSecondIsReported) {
    const TemporaryFolder folder;
    writeTwoSessions(folder / "final");
    writeText(folder / "final" / "final_0.db3", "no database");
    const Made report(folder / "final", folder / "out");
    EXPECT_THAT(report.reported, HasSubstr("final_0.db3"));
    expectTheFinds(report);
    expectNoMap(report);
}

TEST(MissingParts, OfTwoSessionsWhoseFirstHasABrokenHeadAllIsReported) {
    const TemporaryFolder folder;
    writeTwoSessions(folder / "final");
    std::fstream head(folder / "final" / "final_0.db3", std::ios::in | std::ios::out | std::ios::binary);
    head << std::string(100, '?');
    head.close();
    const Made report(folder / "final", folder / "out");
    EXPECT_THAT(report.reported, HasSubstr("final_0.db3"));
    expectTheFinds(report);
    EXPECT_EQ(report.json["scans"], 3) << "its pages are read one by one";
    EXPECT_TRUE(report.has(".tif") && report.has(".ply") && report.has("_kurt3d.tum"));
}

TEST(MissingParts, WhatIsOnlyInAWriteAheadLogIsReported) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "whole" / "final");
    const fs::path log = folder / "whole" / "final" / "final_0.db3", killed = folder / "killed" / "final";
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(log.c_str(), &database), SQLITE_OK);
    const auto run = [&](const char* sql) {
        EXPECT_EQ(sqlite3_exec(database, sql, nullptr, nullptr, nullptr), SQLITE_OK)
            << sqlite3_errmsg(database);
    };
    run("PRAGMA journal_mode=WAL; PRAGMA wal_autocheckpoint=0;");
    // From the first find on; the last checkpoint knows of them too.
    run("CREATE TEMP TABLE late AS SELECT * FROM messages WHERE id >= (SELECT min(id) FROM messages WHERE "
        "topic_id IN (SELECT id FROM topics WHERE name = '/leitstand/victims'));");
    run("DELETE FROM messages WHERE id IN (SELECT id FROM late); PRAGMA wal_checkpoint(TRUNCATE);");
    run("INSERT INTO messages SELECT * FROM late;");
    fs::create_directories(killed.parent_path());
    fs::copy(folder / "whole" / "final", killed, fs::copy_options::recursive);
    sqlite3_close(database);
    fs::remove(killed / "final_0.db3-shm");
    ASSERT_GT(fs::file_size(killed / "final_0.db3-wal"), 0U);
    expectTheFinds(Made(killed, folder / "out"));
    fs::remove(killed / "final_0.db3-wal");
    const auto without = readFindList(Made(killed, folder / "less").file("_victims.csv"));
    ASSERT_TRUE(without) << without.error().text;
    EXPECT_TRUE(without->finds.empty()) << "they were nowhere else";
}

TEST(MissingParts, WithoutTheRobotsFilesTheBagTellsWhoTheyAre) {
    const TemporaryFolder folder;
    writeSampleMission(folder / "final");
    fs::remove_all(folder / "final" / "robots");
    const Made report(folder / "final", folder / "out");
    expectTheFinds(report);
    EXPECT_EQ(report.json["scans"], 3);
    EXPECT_TRUE(report.has(".tif"));
    const auto way = readTum(report.file("_kurt3d.tum"));
    ASSERT_TRUE(way) << way.error().text;
    EXPECT_GT(way->size(), 20U) << "with its odometry";
}

TEST(MissingParts, ABagOfOthersWithoutOdometryIsMappedByItsCloudsAlone) {
    const TemporaryFolder folder;
    {
        ForeignBag bag(folder / "rover");
        for (int step = 0; step <= 4; ++step) bag.sayCloud(step);
    }
    const Made report(folder / "rover", folder / "out");
    EXPECT_GE(report.json["scans"].get<int>(), 2);
    const auto map = readGeoTiff(report.file(".tif"));
    ASSERT_TRUE(map) << map.error().text;
    EXPECT_GT(report.json["explored_m2"].get<double>(), 10.0);
    EXPECT_THAT(report.reported, HasSubstr("no odometry"));
}

TEST(MissingParts, ABagOfOthersWithoutCloudsHasNoMapAndSaysWhy) {
    const TemporaryFolder folder;
    {
        ForeignBag bag(folder / "rover");
        for (int step = 0; step <= 4; ++step) {
            OdometrySample odometry;
            odometry.header = {ForeignBag::at(step), "odom"};
            odometry.childFrame = "base_link";
            odometry.baseInOdom = ForeignBag::baseInRoom(step);
            bag.write(step, "/rover/odom", odometry);
        }
    }
    const Made report(folder / "rover", folder / "out");
    expectNoMap(report);
    EXPECT_THAT(report.reported, AllOf(HasSubstr("there is no map: rover: no scans in it"),
                                       Not(HasSubstr(folder.path().string()))));
    const auto victims = readFindList(report.file("_victims.csv"));
    ASSERT_TRUE(victims) << victims.error().text;
    EXPECT_TRUE(victims->finds.empty());
}

TEST(MissingParts, ADamagedBagOfOthersTellsEachDamageOnce) {
    const TemporaryFolder folder;
    ForeignBag(folder / "rover").drive();
    const fs::path log = folder / "rover" / "rover_0.db3";
    fs::resize_file(log, fs::file_size(log) * 3 / 4);
    const Made report(folder / "rover", folder / "out");
    EXPECT_THAT(report.reported, HasSubstr("rover_0.db3"));
    std::multiset<std::string> warnings;
    for (const auto& one : report.json["warnings"]) warnings.insert(one.get<std::string>());
    for (const std::string& one : warnings) EXPECT_EQ(warnings.count(one), 1U) << one;
}

}  // namespace
}  // namespace leitstand::test
