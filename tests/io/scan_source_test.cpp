#include "core/io/clouds/scan_source.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/file_checks.h"
#include "tests/support/shared_data.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::TemporaryFolder;
using test::written;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(ScanSource, AFolderStandsForItsScansSortedByNumber) {
    const TemporaryFolder folder;
    for (const char* name : {"scan1000.3d", "scan010.3d", "scan9.3d", "scan001.pose", "scan002.frames",
                             "notes.txt", "scanner.3d", "map.pcd"}) {
        written(folder / name, "1 2 3\n");
    }
    const auto files = listScans({folder.path()});
    ASSERT_TRUE(files.ok()) << errorOf(files);
    EXPECT_THAT(*files, ElementsAre(folder / "scan9.3d", folder / "scan010.3d", folder / "scan1000.3d"));
}

TEST(ScanSource, FilesKeepTheGivenOrder) {
    const TemporaryFolder folder;
    const auto b = written(folder / "b.PLY", ""), a = written(folder / "a.xyz", ""),
               c = written(folder / "c.3d", "");
    const auto files = listScans({b, c, a});
    ASSERT_TRUE(files.ok()) << errorOf(files);
    EXPECT_THAT(*files, ElementsAre(b, c, a));
}

TEST(ScanSource, NamesTheSourceThatIsNone) {
    const TemporaryFolder folder;
    EXPECT_THAT(errorOf(listScans({folder / "absent"})), HasSubstr("absent: cannot be opened: No such file"));
    EXPECT_THAT(errorOf(listScans({folder.path()})),
                HasSubstr("expected scans (scan000.3d, ...), found none"));
    EXPECT_THAT(
        errorOf(listScans({written(folder / "a.las", "")})),
        HasSubstr("a.las: expected a folder of scans or a file that ends in .3d, .pcd, .ply or .xyz"));
    EXPECT_THAT(errorOf(readScan(folder / "a.las")), HasSubstr("a.las: expected an ending .3d, .pcd"));
}

TEST(ScanSource, ABrokenFileIsAnErrorForThatFileOnly) {
    const TemporaryFolder folder;
    written(folder / "scan000.3d", "1 2 3\n");
    written(folder / "scan001.3d", "1 2 3\nabc\n");
    std::filesystem::create_symlink("nowhere", folder / "scan002.3d");
    written(folder / "scan003.3d", "4 5 6\n");
    const auto files = listScans({folder.path()});
    ASSERT_TRUE(files.ok()) << errorOf(files);
    ASSERT_EQ(files->size(), 4U);
    EXPECT_TRUE(readScan((*files)[0]).ok());
    EXPECT_THAT(errorOf(readScan((*files)[1])),
                HasSubstr("scan001.3d:2: expected three numbers, found \"abc\""));
    EXPECT_THAT(errorOf(readScan((*files)[2])), HasSubstr("scan002.3d: cannot be opened"));
    EXPECT_TRUE(readScan((*files)[3]).ok());
}

TEST(ScanSource, TheHallHasThreeScans) {
    LEITSTAND_HALL_OR_SKIP(hall);
    const auto files = listScans({hall});
    ASSERT_TRUE(files.ok()) << errorOf(files);
    EXPECT_THAT(*files, ElementsAre(hall / "scan000.3d", hall / "scan001.3d", hall / "scan002.3d"));
    for (const auto& file : *files) EXPECT_TRUE(readScan(file).ok());
}

}  // namespace
}  // namespace leitstand
