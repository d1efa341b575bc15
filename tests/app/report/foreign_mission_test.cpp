#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/services/handin/report_source.h"
#include "core/io/handin/geotiff.h"
#include "tests/app/report/foreign_bag.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// Names and sizes of the files in @p folder.
std::string filesOf(const fs::path& folder) {
    std::vector<std::string> files;
    for (const auto& entry : fs::directory_iterator(folder))
        files.push_back(entry.path().filename().string() + " " + std::to_string(entry.file_size()));
    std::sort(files.begin(), files.end());
    std::string all;
    for (const std::string& one : files) all += one + "; ";
    return all;
}

TEST(ForeignReport, TrailAndStartAreTheBasesAndNotTheScanners) {
    const TemporaryFolder folder;
    ForeignBag(folder / "rover").drive();
    const auto source = ReportSource::open(folder / "rover");
    ASSERT_TRUE(source) << source.error().text;
    ASSERT_GE(source->input().scans.size(), 5u);
    for (const ReportScan& scan : source->input().scans) {
        const Eigen::Vector3d sits = scan.sensorInBase.translation();
        EXPECT_LT((sits - Eigen::Vector3d(ForeignBag::Ahead, 0.0, ForeignBag::Up)).norm(), 1e-6)
            << sits.transpose();
    }
    const ReportModel model = reportOf(source->input());
    ASSERT_EQ(model.robots.size(), 1u);
    const auto& path = model.robots.front().path.poses;
    ASSERT_GT(path.size(), 6u);
    EXPECT_LT(path.front().baseInMap.translation().norm(), 0.02) << "it starts at the map's origin";
    // The turn on the spot: the scanner goes along an arc of 0.63 m, the base stays.
    const Pose startInRoom = ForeignBag::baseInRoom(0);
    for (const PathPose& pose : path) {
        const double seconds = std::chrono::duration<double>(pose.time - ForeignBag::at(0)).count();
        const Pose truth =
            startInRoom.inverse() * ForeignBag::baseInRoom(static_cast<int>(std::floor(seconds)));
        // Odometry's heading is the map's.
        const Pose turned = poseFrom(Eigen::Vector3d::Zero(), 0, 0, degrees(30));
        EXPECT_LT((pose.baseInMap.translation() - turned * truth.translation()).norm(), 0.06) << seconds;
    }
    EXPECT_NEAR(model.robots.front().length, 1.2, 0.1);
}

TEST(ForeignReport, TheWholeFolderIsWrittenAndReadAgain) {
    const TemporaryFolder folder;
    ForeignBag(folder / "rover").drive();
    const std::string before = filesOf(folder / "rover");
    const fs::path out = folder / "out";
    const ProcessOutcome made = runProcess(
        program("leitstandctl"), {"report", (folder / "rover").string(), "--out", out.string(), "--json"});
    ASSERT_EQ(made.exitCode, 0) << made.out << made.err;
    const auto json = nlohmann::json::parse(made.out);
    EXPECT_GE(json["scans"].get<int>(), 5);
    EXPECT_FALSE(json["files"].empty());
    for (const auto& one : json["files"]) EXPECT_TRUE(one["whole"].get<bool>()) << one;
    for (const char* ending : {".tif", "_upper.tif", ".bt", ".ply", "_rover.tum", ".pdf"})
        EXPECT_TRUE(fs::exists(out / ("Competition-Team-rover" + std::string(ending)))) << ending;
    const auto map = readGeoTiff(out / "Competition-Team-rover.tif");
    ASSERT_TRUE(map) << map.error().text;
    const ProcessOutcome sums =
        runProcess("/bin/sh", {"-c", "cd '" + out.string() + "' && sha256sum --check --strict SHA256SUMS"});
    EXPECT_EQ(sums.exitCode, 0) << sums.out << sums.err;
    EXPECT_EQ(filesOf(folder / "rover"), before) << "the bag stays as it is";
}

}  // namespace
}  // namespace leitstand::test
