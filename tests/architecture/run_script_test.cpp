// What people type: packaging/leitstand, with stand-ins for what it builds and asks.
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// A checkout where everything is installed and built, and the station says what it was started with.
class RunScript : public testing::Test {
protected:
    RunScript() {
        fs::create_directories(m_root / "packaging");
        fs::create_directories(m_root / "build/release/bin");
        fs::create_directories(m_root / "tools");
        fs::copy_file(fs::path(sourceFolder()) / "packaging/leitstand", script());
        writeText(m_root / "packaging/debian-packages.txt", "cmake\n");
        program("build/release/bin/leitstand", "echo \"started with: $*\"");
        program("packaging/tidy", "exit 0");
        program("tools/cmake", "exit 0");
        program("tools/dpkg-query", "printf 'install ok installed'");
    }
    [[nodiscard]] ProcessOutcome run(std::vector<std::string> arguments) const {
        const std::string path = "PATH=" + (m_root / "tools").string() + ":/usr/local/bin:/usr/bin:/bin";
        arguments.insert(arguments.begin(), {path, "DISPLAY=:0", script().string()});
        return runProcess("/usr/bin/env", arguments);
    }

    /// From now on the test called @p name fails beside others, and passes alone.
    void failingBesideOthers(const std::string& name) const {
        fs::create_directories(m_root / "build/asan");
        for (const char* tool : {"git", "clang-format-14"}) program(std::string("tools/") + tool, "exit 0");
        const std::string failed = "build/release/Testing/Temporary";
        program("tools/ctest",
                "case \"$*\" in\n"
                "*--rerun-failed*) exit 0 ;;\n"
                "*-N*) echo '  Test #1: " +
                    name +
                    "'; exit 0 ;;\n"
                    "*'-L latency'*) exit 0 ;;\n"
                    "*'preset release'*) mkdir -p " +
                    failed + "; echo '1:" + name + "' >" + failed +
                    "/LastTestsFailed.log; exit 1 ;;\n"
                    "esac\nexit 0");
    }

private:
    [[nodiscard]] fs::path script() const { return m_root / "packaging/leitstand"; }
    void program(const std::string& name, const std::string& does) const {
        writeText(m_root / name, "#!/bin/sh\n" + does + "\n");
        fs::permissions(m_root / name, fs::perms::owner_all);
    }

    const TemporaryFolder m_root;
};

TEST_F(RunScript, StartsTheStationWithItsSimulatedRobotsWhenNothingElseIsAskedFor) {
    const ProcessOutcome run = this->run({"run"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, testing::HasSubstr("started with: --demo\n"));
}

TEST_F(RunScript, HandsOverWhatIsAskedFor) {
    const ProcessOutcome run = this->run({"run", "--theme", "light", "hall"});
    EXPECT_EQ(run.exitCode, 0) << run.err;
    EXPECT_THAT(run.out, testing::HasSubstr("started with: --theme light hall\n"));
}

TEST_F(RunScript, ATestThatNeedsASecondChanceInTwoRunsInARowHasFailed) {
    failingBesideOthers("Odd.One");
    const ProcessOutcome first = run({"test"});
    EXPECT_EQ(first.exitCode, 0) << first.out << first.err;
    EXPECT_THAT(first.out, testing::HasSubstr("UNSTEADY: passed alone only: Odd.One"));
    const ProcessOutcome second = run({"test"});
    EXPECT_NE(second.exitCode, 0) << second.out;
    EXPECT_THAT(second.out, testing::HasSubstr("UNSTEADY twice in a row, which is a failure: Odd.One"));
}

TEST_F(RunScript, ADeafStartHasNoSecondChance) {
    failingBesideOthers("StartLatency.RobotRecorderAndStation");
    EXPECT_NE(run({"test"}).exitCode, 0);
}

TEST(Tidy, FailsForAPlantedDefectAndNamesIt) {
    const TemporaryFolder folder;
    const std::string file = (folder / "planted.cpp").string();
    writeText(file,
              "#include <string>\n#include <utility>\n"
              "std::size_t f(std::string a) {\n    const std::string b = std::move(a);\n"
              "    return a.size() + b.size();\n}\n");
    const ProcessOutcome planted = runProcess(sourceFolder() + "/packaging/tidy", {"--alone", file});
    EXPECT_NE(planted.exitCode, 0);
    EXPECT_THAT(planted.out, testing::HasSubstr("planted.cpp:5:12: error: 'a' used after it was moved"));
    writeText(file, "int f(int a) { return a; }\n");
    EXPECT_EQ(runProcess(sourceFolder() + "/packaging/tidy", {"--alone", file}).exitCode, 0);
}

}  // namespace
}  // namespace leitstand::test
