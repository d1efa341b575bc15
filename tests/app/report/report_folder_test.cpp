#include "app/services/handin/writing/report_folder.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

TEST(ReportFolder, IsKeptWithTheMissionUntilItIsTakenBack) {
    const TemporaryFolder folder;
    EXPECT_EQ(reportFolderOf(folder.path()), fs::path());
    const fs::path out = folder / "hand in, für die Jury";
    ASSERT_TRUE(keepReportFolder(folder.path(), out).ok());
    EXPECT_EQ(reportFolderOf(folder.path()), out);
    ASSERT_TRUE(keepReportFolder(folder.path(), folder / "other").ok());
    EXPECT_EQ(reportFolderOf(folder.path()), folder / "other");
    ASSERT_TRUE(keepReportFolder(folder.path(), {}).ok());
    EXPECT_EQ(reportFolderOf(folder.path()), fs::path());
    EXPECT_TRUE(keepReportFolder(folder.path(), {}).ok()) << "there is nothing to take back";
}

TEST(ReportFolder, DamageIsNoFolder) {
    const TemporaryFolder folder;
    for (const std::string& text : {std::string(), std::string("\n"), std::string("relative/path\n"),
                                    std::string(10'000, '/'), std::string("/tmp/\0x", 7)}) {
        writeText(folder / "report_folder.txt", text);
        EXPECT_EQ(reportFolderOf(folder.path()), fs::path()) << text.size();
    }
}

TEST(ReportFolder, WhereNothingCanBeWrittenSaysSo) {
    const auto kept = keepReportFolder("/proc/nowhere", "/tmp/out");
    ASSERT_FALSE(kept.ok());
    EXPECT_NE(kept.error().text.find("/proc/nowhere"), std::string::npos);
}

}  // namespace
}  // namespace leitstand::test
