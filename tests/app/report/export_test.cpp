// What `leitstandctl export` writes is read again, by our readers and by others.
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/handin/writing/mission_export.h"
#include "core/io/clouds/pcd.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/scan_source.h"
#include "core/io/clouds/tum.h"
#include "core/io/clouds/uos.h"
#include "core/io/handin/find_lists.h"
#include "core/io/handin/geotiff.h"
#include "core/io/handin/octomap_file.h"
#include "core/io/handin/search_list.h"
#include "core/mission/state/find_state.h"
#include "tests/app/report/sample_mission.h"
#include "tests/core/handin/report_scene.h"
#include "tests/support/missing_tool.h"
#include "tests/support/others_tools.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Export : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<TemporaryFolder>();
        writeSampleMission(*s_folder / "final");
    }
    static void TearDownTestSuite() { s_folder.reset(); }
    static std::string mission() { return (*s_folder / "final").string(); }

    /// What is exported to a file of that name.
    [[nodiscard]] fs::path exported(const std::string& name, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"export", mission(), "--out", (m_folder / name).string()});
        m_outcome = runProcess(program("leitstandctl"), more);
        EXPECT_EQ(m_outcome.exitCode, 0) << name << ": " << m_outcome.err;
        return m_folder / name;
    }
    /// Echoes of all scans.
    static std::size_t points() {
        std::size_t count = 0;
        for (const ReportScan& scan : roomScans(3)) {
            for (const Eigen::Vector3f& point : scan.scan->points) count += point.allFinite() ? 1 : 0;
        }
        return count;
    }

    const TemporaryFolder m_folder;
    ProcessOutcome m_outcome;
    static std::unique_ptr<TemporaryFolder> s_folder;
};
std::unique_ptr<TemporaryFolder> Export::s_folder;

TEST_F(Export, CloudsHaveEveryPoint) {
    const auto pcd = readPcd(exported("map.pcd")), ply = readPly(exported("map.ply")),
               xyz = readScan(exported("map.xyz"));
    ASSERT_TRUE(pcd.ok() && ply.ok() && xyz.ok());
    for (const auto* one : {&*pcd, &*ply, &*xyz}) EXPECT_EQ(one->scan.points.size(), points());
    EXPECT_EQ(ply->scan.labels.size(), points());
    Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F), high = -low;
    for (const Eigen::Vector3f& point : pcd->scan.points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    EXPECT_NEAR(high.x() - low.x(), 8.0, 0.5) << "the room, in the map";
    EXPECT_NEAR(high.y() - low.y(), 6.0, 0.5);
}

TEST_F(Export, ReducedCloudsHaveOnePointACube) {
    const auto thin = readPcd(exported("thin.pcd", {"--reduce", "0.1"}));
    ASSERT_TRUE(thin) << thin.error().text;
    EXPECT_LT(thin->scan.points.size(), points() / 3);
    EXPECT_GT(thin->scan.points.size(), 5'000U);
}

TEST_F(Export, TheMapIsAGeoTiffOfTheHeightThatIsAskedFor) {
    // The title is the file's name: other bytes are not yet another height.
    fs::create_directories(m_folder / "upper");
    const fs::path low = exported("map.tif"), upper = exported("upper/map.tif", {"--height", "upper"});
    const auto below = readGeoTiff(low), above = readGeoTiff(upper);
    ASSERT_TRUE(below.ok() && above.ok());
    EXPECT_EQ(below->perPixel, 0.01);
    EXPECT_NE(below->picture.bytes, above->picture.bytes);
    const auto same = readGeoTiff(exported("map.tif"));
    ASSERT_TRUE(same.ok());
    EXPECT_EQ(below->picture.bytes, same->picture.bytes);
    const ProcessOutcome read = readByGdal(low);
    LEITSTAND_NEEDS(read);
    EXPECT_THAT(read.out, HasSubstr("Size is " + std::to_string(below->picture.width) + ", " +
                                    std::to_string(below->picture.height)));
}

TEST_F(Export, EndingsMayBeInCapitals) {
    for (const char* name : {"MAP.TIF", "MAP.BT", "WAY.TUM", "V_VICTIMS.CSV", "MAP.PLY"})
        (void)exported(name);
    const auto victims = readFindList(m_folder / "V_VICTIMS.CSV");
    ASSERT_TRUE(victims) << victims.error().text;
    EXPECT_EQ(victims->kind, FindList::Kind::Victims);
}

TEST_F(Export, WhatWasSearchedIsAListOfItsOwn) {
    EXPECT_TRUE(readSearchList(exported("final_searched.csv")).ok());
    EXPECT_THAT(m_outcome.out, HasSubstr("final_searched.csv: "));
}

TEST_F(Export, TheOctomapHasWallsAndFreeSpace) {
    const fs::path file = exported("map.bt");
    const auto tree = readOctomap(file);
    ASSERT_TRUE(tree) << tree.error().text;
    EXPECT_EQ(tree->cell, 0.05);
    EXPECT_GT(tree->occupied, 0.5);
    EXPECT_GT(tree->free, 20.0);
    const ProcessOutcome read = readByOctomap(file);
    LEITSTAND_NEEDS(read);
    EXPECT_EQ(read.exitCode, 0) << read.err;
}

TEST_F(Export, PointsAreReadByPcl) {
    const fs::path ply = exported("map.ply");
    const ProcessOutcome read = readByPcl(ply, m_folder / "by_pcl.pcd");
    LEITSTAND_NEEDS(read);
    EXPECT_EQ(read.exitCode, 0) << read.err;
    const auto again = readPcd(m_folder / "by_pcl.pcd");
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_EQ(again->scan.points.size(), points());
}

TEST_F(Export, TheTrajectoryOfTheOnlyRobotIsTheFileThatWasAskedFor) {
    const fs::path file = exported("way.tum");
    const auto way = readTum(file);
    ASSERT_TRUE(way) << way.error().text;
    EXPECT_GT(way->size(), 20U);
    EXPECT_NEAR(way->front().pose.translation().x(), -1.0, 0.1);
    EXPECT_THAT(m_outcome.out, HasSubstr(file.string() + ": "));
    EXPECT_FALSE(fs::exists(m_folder / "way_kurt3d.tum"));
    const fs::path named = exported("k.tum", {"--robot", "kurt3d", "--json"});
    EXPECT_TRUE(readTum(named));
    const auto files = nlohmann::json::parse(m_outcome.out)["files"];
    ASSERT_EQ(files.size(), 1U);
    EXPECT_EQ(files[0]["file"], named.string());
}

TEST_F(Export, ListsAreThoseThatTheirNamesSay) {
    const auto all = readFindList(exported("all.csv")), victims = readFindList(exported("x_victims.csv")),
               codes = readFindList(exported("x_qr.csv"));
    ASSERT_TRUE(all.ok() && victims.ok() && codes.ok());
    EXPECT_EQ(all->finds.size(), 4U);
    ASSERT_EQ(victims->finds.size(), 1U);
    EXPECT_EQ(victims->finds[0].text, "V1");
    ASSERT_EQ(codes->finds.size(), 1U);
    EXPECT_EQ(codes->finds[0].text, "exit, \"left\"");
}

TEST_F(Export, UosScansHaveTheirPointsAndPlaces) {
    const fs::path folder = exported("uos/");
    const auto scans = roomScans(3);
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const std::string name = "scan00" + std::to_string(i);
        const auto scan = readUosScan(folder / (name + ".3d"));
        ASSERT_TRUE(scan) << scan.error().text;
        EXPECT_GT(scan->scan.points.size(), 10'000U) << name;
        const auto pose = readUosPose(folder / (name + ".pose"));
        ASSERT_TRUE(pose) << pose.error().text;
        EXPECT_LT(distanceBetween(*pose, scans[i].scanInMap), 0.01) << name;
    }
    EXPECT_FALSE(fs::exists(folder / "scan003.3d"));
}

TEST_F(Export, OfSeveralRobotsEachHasATrajectoryAndTheNamesAreTold) {
    const fs::path sample = fs::path(sourceFolder()) / "resources/samples/yellow-7";
    const fs::path asked = m_folder / "way.tum";
    const ProcessOutcome all =
        runProcess(program("leitstandctl"), {"export", sample.string(), "--out", asked.string()});
    ASSERT_EQ(all.exitCode, 0) << all.err;
    EXPECT_FALSE(fs::exists(asked)) << "whose would it be?";
    for (const char* robot : {"kurt3d", "crawler"}) {
        const fs::path file = m_folder / (std::string("way_") + robot + ".tum");
        EXPECT_TRUE(readTum(file)) << robot;
        EXPECT_THAT(all.out, HasSubstr(file.string() + ": "));
    }
    const ProcessOutcome one = runProcess(
        program("leitstandctl"), {"export", sample.string(), "--out", asked.string(), "--robot", "crawler"});
    ASSERT_EQ(one.exitCode, 0) << one.err;
    EXPECT_EQ(readText(asked), readText(m_folder / "way_crawler.tum"));
}

TEST_F(Export, EachFormatIsWrittenReadAgainAndInTheHelp) {
    const ProcessOutcome help = runProcess(program("leitstandctl"), {"export", "--help"});
    for (const ExportFormat& format : exportFormats()) {
        const fs::path file = exported("each" + format.ending);
        EXPECT_TRUE(fs::exists(file)) << format.ending;
        EXPECT_THAT(help.out, HasSubstr(format.ending));
        EXPECT_THAT(help.out, HasSubstr(format.subject));
    }
}

TEST_F(Export, TheHelpSaysHowTrajectoriesOfSeveralRobotsAreNamed) {
    const ProcessOutcome help = runProcess(program("leitstandctl"), {"export", "--help"});
    EXPECT_EQ(help.exitCode, 0);
    EXPECT_THAT(help.out, HasSubstr("NAME_ROBOT.tum"));
}

}  // namespace
}  // namespace leitstand::test
