// Reading a hand-in again finds what is broken in it.
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/session/report/report_files.h"
#include "tests/app/report/sample_mission.h"
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
    static void expectBroken(const fs::path& file) {
        const auto check = checkFile(file);
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
