#include <filesystem>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/clouds/ply.h"
#include "tests/support/missing_tool.h"
#include "tests/support/others_tools.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// The hand-in of the shipped mission, whose robots drove by themselves, read by programs that we did not
/// write.
class ReadByOthers : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_folder = std::make_unique<TemporaryFolder>();
        s_outcome =
            runProcess(program("leitstandctl"), {"report", mission().string(), "--out", out().string()});
    }
    static void TearDownTestSuite() { s_folder.reset(); }
    void SetUp() override { ASSERT_EQ(s_outcome.exitCode, 0) << s_outcome.err; }

    static fs::path mission() { return fs::path(sourceFolder()) / "resources/samples/yellow-7"; }
    static fs::path out() { return *s_folder / "out"; }
    static fs::path file(const std::string& ending) {
        return out() / ("RoboCup2026-Leitstand-Sample" + ending);
    }
    static std::unique_ptr<TemporaryFolder> s_folder;
    static ProcessOutcome s_outcome;
};
std::unique_ptr<TemporaryFolder> ReadByOthers::s_folder;
ProcessOutcome ReadByOthers::s_outcome;

TEST_F(ReadByOthers, MapsByGdal) {
    for (const char* ending : {".tif", "_upper.tif"}) {
        const ProcessOutcome read = readByGdal(file(ending));
        LEITSTAND_NEEDS(read);
        EXPECT_EQ(read.exitCode, 0) << read.err;
        EXPECT_THAT(read.out,
                    AllOf(HasSubstr("GTiff"), HasSubstr("Pixel Size = (0.01"), HasSubstr("Band 3")));
    }
}

TEST_F(ReadByOthers, TheOctomapByItsTools) {
    const ProcessOutcome read = readByOctomap(file(".bt"));
    LEITSTAND_NEEDS(read);
    EXPECT_EQ(read.exitCode, 0) << read.err;
    EXPECT_GT(fs::file_size(file(".bt.wrl")), 100'000u);
}

TEST_F(ReadByOthers, ThePointsByPcl) {
    const ProcessOutcome read = readByPcl(file(".ply"), *s_folder / "points.pcd");
    LEITSTAND_NEEDS(read);
    EXPECT_EQ(read.exitCode, 0) << read.out << read.err;
    EXPECT_THAT(read.out + read.err, HasSubstr("x y z label"));
    const auto ours = readPly(file(".ply"));
    ASSERT_TRUE(ours) << ours.error().text;
    EXPECT_THAT(readText(*s_folder / "points.pcd"),
                HasSubstr("POINTS " + std::to_string(ours->scan.points.size()) + "\n"));
}

TEST_F(ReadByOthers, ThePagesByPoppler) {
    const ProcessOutcome read = readByPoppler(file(".pdf"));
    LEITSTAND_NEEDS(read);
    EXPECT_EQ(read.exitCode, 0) << read.err;
    EXPECT_THAT(read.out, AllOf(HasSubstr("Leitstand"), HasSubstr("V1")));
}

TEST_F(ReadByOthers, TheLogByNpm) {
    const ProcessOutcome read = readByNpm(mission());
    LEITSTAND_NEEDS(read);
    EXPECT_EQ(read.exitCode, 0) << read.out << read.err;
    EXPECT_THAT(read.out, HasSubstr("\"messages\":"));
}

}  // namespace
}  // namespace leitstand::test
