// Where things are in a hand-in, as programs read it that we did not write.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/io/clouds/pcd.h"
#include "core/io/handin/geotiff.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/missing_tool.h"
#include "tests/support/others_tools.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The hand-in of a mission whose room and finds are known.
class PlacesByOthers : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<TemporaryFolder>();
        writeSampleMission(*s_folder / "final");
        s_outcome = runProcess(program("leitstandctl"), {"report", (*s_folder / "final").string(), "--out",
                                                         (*s_folder / "out").string(), "--no-pdf"});
    }
    static void TearDownTestSuite() { s_folder.reset(); }
    void SetUp() override { ASSERT_EQ(s_outcome.exitCode, 0) << s_outcome.err; }
    static fs::path file(const std::string& ending) {
        return *s_folder / "out" / ("RoboCup2013-Deutschland1-Final_1" + ending);
    }
    static std::unique_ptr<TemporaryFolder> s_folder;
    static ProcessOutcome s_outcome;
};
std::unique_ptr<TemporaryFolder> PlacesByOthers::s_folder;
ProcessOutcome PlacesByOthers::s_outcome;

TEST_F(PlacesByOthers, GdalHasTheMapsCornerWhereWeHaveIt) {
    for (const char* ending : {".tif", "_upper.tif"}) {
        const ProcessOutcome read = readByGdal(file(ending));
        LEITSTAND_NEEDS(read);
        const auto map = readGeoTiff(file(ending));
        ASSERT_TRUE(map) << map.error().text;
        EXPECT_THAT(read.out, HasSubstr(fmt::format("Origin = ({:.15f},{:.15f})", -map->topLeft.y(),
                                                    map->topLeft.x())));
        EXPECT_THAT(read.out, HasSubstr("Pixel Size = (0.010000000000000,-0.010000000000000)"));
    }
}

TEST_F(PlacesByOthers, GdalFindsVictimStartAndWallWhereTheyAre) {
    struct {
        const char* what;
        double x, y;  ///< in the map [m]
        const char* colour;
    } const places[] = {
        {"the victim, beside its number", 1.5 + 0.14, 1.0, "240 10 10"},
        {"what may be a victim", -2.0, -1.5, "240 100 10"},
        {"the hazard, beside its number", 2.5 + 0.17, -1.0, "255 100 30"},
        {"the code", 0.5, -2.5, "10 10 240"},
        {"the object", -1.0, 2.0, "10 240 10"},
        {"where the robot began", -1.0, 0.0, "255 200 0"},
    };
    for (const auto& place : places) {
        const ProcessOutcome read = colourByGdal(file(".tif"), place.x, place.y);
        LEITSTAND_NEEDS(read);
        EXPECT_EQ(read.exitCode, 0) << read.err;
        EXPECT_EQ(read.out, place.colour) << place.what;
    }
    int walls = 0;
    for (double x = -1.5; x < 1.5; x += 0.25) {
        for (const double y : {-2.98, -3.02})
            walls += colourByGdal(file(".tif"), x, y).out == "0 40 120" ? 1 : 0;
    }
    EXPECT_GE(walls, 9) << "of 12 places along the right wall";
}

/// The middles of the cubes that bt2vrml tells.
std::vector<Eigen::Vector3f> cubesOf(const fs::path& vrml) {
    std::istringstream words(readText(vrml));
    std::vector<Eigen::Vector3f> cubes;
    for (std::string word; words >> word;) {
        Eigen::Vector3f at;
        if (word == "translation" && words >> at.x() >> at.y() >> at.z()) cubes.push_back(at);
    }
    return cubes;
}

TEST_F(PlacesByOthers, TheOctomapHasItsCubesWhereThePointsAre) {
    const ProcessOutcome tree = readByOctomap(file(".bt"));
    LEITSTAND_NEEDS(tree);
    ASSERT_EQ(tree.exitCode, 0) << tree.err;
    const ProcessOutcome cloud = readByPcl(file(".ply"), *s_folder / "points.pcd");
    LEITSTAND_NEEDS(cloud);
    ASSERT_EQ(cloud.exitCode, 0) << cloud.out << cloud.err;
    const auto points = readPcd(*s_folder / "points.pcd");
    ASSERT_TRUE(points) << points.error().text;
    const std::vector<Eigen::Vector3f> cubes = cubesOf(file(".bt.wrl"));
    ASSERT_GT(cubes.size(), 1000U);
    std::size_t looked = 0, there = 0;
    for (std::size_t i = 0; i < cubes.size(); i += cubes.size() / 200) {
        ++looked;
        // Joined cubes are 0.1 m and more across.
        there += std::any_of(points->scan.points.begin(), points->scan.points.end(),
                             [&](const Eigen::Vector3f& point) {
                                 return (point - cubes[i]).cwiseAbs().maxCoeff() < 0.11F;
                             })
                     ? 1
                     : 0;
    }
    EXPECT_GE(there, looked * 19 / 20) << "of " << looked;
    Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F), high = -low;
    for (const Eigen::Vector3f& point : points->scan.points) {
        low = low.cwiseMin(point);
        high = high.cwiseMax(point);
    }
    EXPECT_LT((low - Eigen::Vector3f(-4.0F, -3.0F, 0.0F)).cwiseAbs().maxCoeff(), 0.1F) << low.transpose();
    EXPECT_LT((high - Eigen::Vector3f(4.0F, 3.0F, 2.6F)).cwiseAbs().maxCoeff(), 0.1F) << high.transpose();
}

TEST_F(PlacesByOthers, PythonReadsTheLists) {
    const ProcessOutcome read = readByPython(
        "import csv, json, sys\n"
        "print(json.dumps(list(csv.reader(open(sys.argv[1], newline='')))))",
        file("_pois.csv"));
    LEITSTAND_NEEDS(read);
    ASSERT_EQ(read.exitCode, 0) << read.err;
    const auto rows = nlohmann::json::parse(read.out);
    ASSERT_EQ(rows.size(), 7U + 1U + 1U + 4U) << "type to mission, an empty line, the columns, four finds";
    EXPECT_EQ(rows[0], nlohmann::json({"pois"}));
    EXPECT_EQ(rows[2], nlohmann::json({"Deutschland1"}));
    EXPECT_TRUE(rows[7].empty());
    EXPECT_EQ(rows[8], nlohmann::json({"id", "time", "text", "x", "y", "z", "robot", "mode", "type"}));
    const auto& code = rows[11];
    EXPECT_EQ(code[2], "exit, \"left\"") << "a comma and quotes within a field";
    EXPECT_NEAR(std::stod(code[3].get<std::string>()), 0.5, 1e-9);
    EXPECT_NEAR(std::stod(code[4].get<std::string>()), -2.5, 1e-9);
    EXPECT_EQ(code[8], "qr");
}

TEST_F(PlacesByOthers, PythonReadsTheOtherLists) {
    const std::map<std::string, std::string> columns = {{"_victims.csv", "id,time,name,x,y,z"},
                                                        {"_qr.csv", "id,time,text,x,y,z,robot,mode"}};
    for (const auto& [ending, line] : columns) {
        const ProcessOutcome read = readByPython(
            "import csv, json, sys\n"
            "rows = list(csv.reader(open(sys.argv[1], newline='')))\n"
            "head = [i for i, row in enumerate(rows) if row[:2] == ['id', 'time']][0]\n"
            "wide = {len(row) for row in rows[head:]}\n"
            "print(json.dumps({'columns': ','.join(rows[head]), 'wide': len(wide), 'finds': len(rows) - head "
            "- 1}))",
            file(ending));
        LEITSTAND_NEEDS(read);
        ASSERT_EQ(read.exitCode, 0) << read.err;
        const auto reported = nlohmann::json::parse(read.out);
        EXPECT_EQ(reported["columns"], line) << ending;
        EXPECT_EQ(reported["wide"], 1) << ending << ": every row has every column";
        EXPECT_EQ(reported["finds"], 1) << ending;
    }
}

TEST_F(PlacesByOthers, PythonReadsTheTrajectory) {
    const ProcessOutcome read = readByPython(
        "import json, sys\n"
        "rows = [[float(word) for word in line.split()] for line in open(sys.argv[1]) if line[0] != '#']\n"
        "print(json.dumps(rows))",
        file("_kurt3d.tum"));
    LEITSTAND_NEEDS(read);
    ASSERT_EQ(read.exitCode, 0) << read.err;
    const auto rows = nlohmann::json::parse(read.out);
    ASSERT_GT(rows.size(), 20U);
    double before = 0.0;
    for (const auto& row : rows) {
        ASSERT_EQ(row.size(), 8U) << "t x y z qx qy qz qw";
        EXPECT_GT(row[0].get<double>(), before) << "times rise";
        before = row[0];
        const double norm = std::hypot(std::hypot(row[4].get<double>(), row[5].get<double>()),
                                       std::hypot(row[6].get<double>(), row[7].get<double>()));
        EXPECT_NEAR(norm, 1.0, 1e-6) << "a rotation";
        EXPECT_NEAR(row[2].get<double>(), 0.0, 0.1);
    }
    EXPECT_NEAR(rows.front()[1].get<double>(), -1.0, 0.1);
}

}  // namespace
}  // namespace leitstand::test
