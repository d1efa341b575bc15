// Reading a hand-in again finds what is broken in it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/handin/writing/report_files.h"
#include "core/io/clouds/ply.h"
#include "core/io/handin/geotiff.h"
#include "tests/app/report/sample_mission.h"
#include "tests/core/handin/report_scene.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* Name = "RoboCup2013-Deutschland1-Final_1";

/// A hand-in, and a copy of it that each test damages.
class CheckFile : public testing::TestWithParam<const char*> {
protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<TemporaryFolder>();
        writeSampleMission(*s_folder / "final");
        const ProcessOutcome made = runProcess(
            program("leitstandctl"), {"report", (*s_folder / "final").string(), "--out", out().string()});
        ASSERT_EQ(made.exitCode, 0) << made.err;
    }
    static void TearDownTestSuite() { s_folder.reset(); }
    static fs::path out() { return *s_folder / "out"; }

    /// A copy of the file that ends so.
    [[nodiscard]] fs::path copied(const std::string& ending) const {
        const std::string name = ending == "SHA256SUMS" ? ending : Name + ending;
        fs::copy_file(out() / name, m_folder / name);
        return m_folder / name;
    }
    static void expectBroken(const fs::path& file, const FileContents& expected = {}) {
        const auto check = checkFile(file, expected);
        ASSERT_FALSE(check.ok()) << file << ": " << *check;
        EXPECT_THAT(check.error().text, HasSubstr(file.filename().string())) << "names the file";
        EXPECT_GT(check.error().text.size(), file.string().size() + 5U) << "and why";
    }

    const TemporaryFolder m_folder;
    static std::unique_ptr<TemporaryFolder> s_folder;
};
std::unique_ptr<TemporaryFolder> CheckFile::s_folder;

TEST_P(CheckFile, AWholeOneIsWhole) {
    const auto check = checkFile(copied(GetParam()));
    ASSERT_TRUE(check) << check.error().text;
    EXPECT_FALSE(check->empty());
}

TEST_P(CheckFile, AHalfOneIsBroken) {
    const fs::path file = copied(GetParam());
    fs::resize_file(file, fs::file_size(file) / 2);
    expectBroken(file);
}

TEST_P(CheckFile, AnEmptyOneIsBroken) {
    const fs::path file = copied(GetParam());
    fs::resize_file(file, 0);
    expectBroken(file);
}

TEST_P(CheckFile, OneWithAnotherBeginningIsBroken) {
    const fs::path file = copied(GetParam());
    std::fstream bytes(file, std::ios::binary | std::ios::in | std::ios::out);
    bytes << std::string(16, '?');
    bytes.close();
    expectBroken(file);
}

INSTANTIATE_TEST_SUITE_P(Kinds, CheckFile, testing::Values(".tif", "_upper.tif", ".bt", ".ply", ".pdf"),
                         [](const auto& one) {
                             std::string name = one.param;
                             std::erase_if(name, [](char letter) { return letter == '.' || letter == '_'; });
                             return name;
                         });

using CheckOneFile = CheckFile;

TEST_F(CheckOneFile, AListWithoutItsColumnsIsBroken) {
    for (const char* ending : {"_victims.csv", "_qr.csv", "_pois.csv"}) {
        const fs::path file = copied(ending);
        ASSERT_TRUE(checkFile(file)) << ending;
        const std::string text = readText(file);
        fs::resize_file(file, text.find("\n\n"));
        expectBroken(file);
        fs::resize_file(file, 0);
        expectBroken(file);
    }
}

TEST_F(CheckOneFile, ATrajectoryWithABrokenLineIsBroken) {
    const fs::path file = copied("_kurt3d.tum");
    ASSERT_TRUE(checkFile(file));
    std::ofstream(file, std::ios::app) << "1.0 2.0 here\n";
    expectBroken(file);
}

/// @p file without its last line.
void cutLastLine(const fs::path& file) {
    const std::string text = readText(file);
    fs::resize_file(file, text.rfind('\n', text.size() - 2) + 1);
}

TEST_F(CheckOneFile, AListOrATrajectoryThatEndsARowTooEarlyIsBroken) {
    for (const char* ending : {"_pois.csv", "_searched.csv", "_kurt3d.tum"}) {
        const fs::path file = copied(ending);
        const std::string text = readText(file), rows = text.substr(text.find("\n\n") + 1);
        const auto lines = static_cast<std::size_t>(std::count(rows.begin(), rows.end(), '\n'));
        // Before the rows: an empty line and the columns, or a line that tells the columns.
        const std::size_t whole = lines - (ending == std::string("_pois.csv") ? 2 : 1);
        EXPECT_TRUE(checkFile(file, {.count = whole})) << ending;
        cutLastLine(file);
        EXPECT_TRUE(checkFile(file)) << ending << ": it can be read all the same";
        expectBroken(file, {.count = whole});
    }
}

TEST_F(CheckOneFile, AMapOfAnotherPlaceOrSizeIsBroken) {
    const fs::path file = copied(".tif");
    const auto map = readGeoTiff(file);
    ASSERT_TRUE(map) << map.error().text;
    EXPECT_TRUE(checkFile(file, contentsOf(*map)));
    FileContents shifted = contentsOf(*map), larger = shifted, coarser = shifted;
    shifted.frame->topLeft.y() += 0.01;
    larger.frame->height += 1;
    coarser.frame->perPixel = 0.02;
    for (const FileContents& other : {shifted, larger, coarser}) expectBroken(file, other);
}

TEST_F(CheckOneFile, APdfWithTooFewPagesAndACloudOfOtherPointsAreBroken) {
    const fs::path pages = copied(".pdf"), cloud = copied(".ply");
    EXPECT_TRUE(checkFile(pages, {.count = 8})) << "a cover, two maps, five finds";
    expectBroken(pages, {.count = 100});
    const auto read = readPly(cloud);
    ASSERT_TRUE(read) << read.error().text;
    EXPECT_TRUE(checkFile(cloud, {.count = read->scan.points.size()}));
    expectBroken(cloud, {.count = read->scan.points.size() + 1});
}

TEST_F(CheckOneFile, AnExportedCloudIsComparedWithItsScans) {
    std::vector<PlacedScan> scans;
    for (const ReportScan& one : roomScans(2)) scans.push_back({one.scan, one.scanInMap});
    const fs::path text = m_folder / "map.xyz", folder = m_folder / "uos/";
    for (const fs::path& out : {text, fs::path(m_folder / "map.pcd"), folder}) {
        const auto written = writeMapCloud(out, scans);
        ASSERT_TRUE(written) << written.error().text;
        const auto check = checkMapCloud(out, scans);
        EXPECT_TRUE(check) << check.error().text;
    }
    cutLastLine(text);
    const auto shorter = checkMapCloud(text, scans);
    ASSERT_FALSE(shorter);
    EXPECT_THAT(shorter.error().text, HasSubstr("map.xyz: expected"));
    cutLastLine(folder / "scan001.3d");
    const auto inFolder = checkMapCloud(folder, scans);
    ASSERT_FALSE(inFolder);
    EXPECT_THAT(inFolder.error().text, HasSubstr("scan001.3d: expected"));
    fs::remove(folder / "scan001.3d");
    EXPECT_FALSE(checkMapCloud(folder, scans)) << "a scan is missing";
}

TEST_F(CheckOneFile, SumsThatAreNotTheFilesAreBroken) {
    for (const auto& entry : fs::directory_iterator(out()))
        fs::copy_file(entry.path(), m_folder / entry.path().filename());
    const fs::path sums = m_folder / "SHA256SUMS";
    ASSERT_TRUE(checkFile(sums)) << checkFile(sums).error().text;
    std::ofstream(m_folder / (std::string(Name) + "_qr.csv"), std::ios::app) << " ";
    const auto changed = checkFile(sums);
    ASSERT_FALSE(changed);
    EXPECT_THAT(changed.error().text, HasSubstr("_qr.csv"));
    fs::remove(m_folder / (std::string(Name) + ".bt"));
    EXPECT_FALSE(checkFile(sums));
}

TEST_F(CheckOneFile, AFileThatIsNoneOfAReportsIsToldSo) {
    writeText(m_folder / "notes.txt", "hello");
    expectBroken(m_folder / "notes.txt");
    EXPECT_FALSE(checkFile(m_folder / "absent.tif"));
    EXPECT_FALSE(checkFile(m_folder / "absent.pdf"));
}

}  // namespace
}  // namespace leitstand::test
