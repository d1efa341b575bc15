// What is installed works where it is installed, and is built without what only tests need.
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"
#include "transport/dds/network/socket_buffers.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

const fs::path& source() {
    static const fs::path folder = sourceFolder();
    return folder;
}

/// All that is installed, in a folder that stands for the root of a system.
class InstalledTree : public testing::Test {
protected:
    static void SetUpTestSuite() {
        s_root = std::make_unique<TemporaryFolder>();
        const fs::path build = fs::path(program("leitstandctl")).parent_path().parent_path();
        const ProcessOutcome done = runProcess(
            "/usr/bin/env",
            {"DESTDIR=" + s_root->path().string(), "cmake", "--install", build.string(), "--prefix", "/usr"});
        ASSERT_EQ(done.exitCode, 0) << done.err;
    }
    static void TearDownTestSuite() { s_root.reset(); }

    [[nodiscard]] static fs::path usr() { return s_root->path() / "usr"; }
    /// Runs an installed program as somebody whose environment tells nothing.
    [[nodiscard]] static ProcessOutcome runInstalled(const std::string& name,
                                                     std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"-i", "PATH=/usr/bin:/bin", "HOME=" + s_root->path().string(),
                                             (usr() / "bin" / name).string()});
        return runProcess("/usr/bin/env", arguments);
    }
    static std::unique_ptr<TemporaryFolder> s_root;
};
std::unique_ptr<TemporaryFolder> InstalledTree::s_root;

TEST_F(InstalledTree, RobotsAreKnownByName) {
    const ProcessOutcome run = runInstalled("leitstandctl", {"record", "--robot", "nobody", "--out", "x"});
    EXPECT_EQ(run.exitCode, 1);
    for (const auto& file : fs::directory_iterator(source() / "resources/robots"))
        EXPECT_THAT(run.err, HasSubstr(file.path().stem().string()));
}

TEST_F(InstalledTree, TheSampleIsReported) {
    const ProcessOutcome run =
        runInstalled("leitstandctl", {"report", (usr() / "share/leitstand/samples/yellow-7").string(),
                                      "--out", (usr() / "handin").string()});
    EXPECT_EQ(run.exitCode, 0) << run.err;
}

TEST_F(InstalledTree, HasAllThatProgramsReadAndNothingOfTheBuild) {
    for (const char* file : {"share/leitstand/robots/kurt3d.yaml", "share/leitstand/control/fuzzy_drive.yaml",
                             "share/leitstand/layouts/drive.yaml", "share/leitstand/scoring/2005.json",
                             "share/leitstand/samples/yellow-7/metadata.yaml",
                             "share/applications/org.leitstand.leitstand.desktop",
                             "share/man/man1/leitstandctl.1.gz", "share/doc/leitstand-tools/copyright"})
        EXPECT_TRUE(fs::exists(usr() / file)) << file;
    std::set<std::string> extensions;
    for (const auto& entry : fs::recursive_directory_iterator(usr()))
        extensions.insert(entry.path().extension().string());
    for (const char* developers : {".a", ".h", ".cmake", ".cpp", ".stamp", ".py", ".ts"})
        EXPECT_FALSE(extensions.contains(developers)) << developers;
}

TEST_F(InstalledTree, RaisesTheLimitsOfSocketBuffersToWhatProgramsAskFor) {
    const std::string conf = readText(s_root->path() / "etc/sysctl.d/60-leitstand.conf");
    for (const char* limit : {"rmem_max", "wmem_max"})
        EXPECT_THAT(conf, HasSubstr(fmt::format("net.core.{} = {}\n", limit, detail::SocketBufferSize)));
}

/// Width and height that a PNG tells.
std::array<std::uint32_t, 2> sizeOf(const fs::path& png) {
    std::ifstream in(png, std::ios::binary);
    std::array<unsigned char, 24> head{};
    in.read(reinterpret_cast<char*>(head.data()), head.size());
    const auto number = [&head](std::size_t at) {
        return static_cast<std::uint32_t>(head[at] << 24 | head[at + 1] << 16 | head[at + 2] << 8 |
                                          head[at + 3]);
    };
    return {number(16), number(20)};
}

TEST_F(InstalledTree, HasTheIconInEachSize) {
    for (const std::uint32_t size : {16U, 22U, 24U, 32U, 48U, 64U, 128U, 256U, 512U}) {
        const fs::path icon =
            usr() / fmt::format("share/icons/hicolor/{0}x{0}/apps/org.leitstand.leitstand.png", size);
        EXPECT_EQ(sizeOf(icon), (std::array{size, size})) << icon;
    }
    EXPECT_TRUE(fs::exists(usr() / "share/icons/hicolor/scalable/apps/org.leitstand.leitstand.svg"));
}

TEST_F(InstalledTree, DesktopEntriesOpenTheTypesThatAreDefined) {
    const std::string types = readText(usr() / "share/mime/packages/leitstand.xml");
    const std::regex mime("[;=](application/x-[a-z0-9-]+)");
    std::set<std::string> opened;
    for (const char* name : {"org.leitstand.leitstand", "org.leitstand.leitstand.robot"}) {
        const std::string entry = readText(usr() / "share/applications" / (std::string(name) + ".desktop"));
        for (std::sregex_iterator one(entry.begin(), entry.end(), mime), end; one != end; ++one)
            opened.insert((*one)[1]);
        EXPECT_THAT(entry, HasSubstr("\nExec=leitstand "));
    }
    for (const std::string& one : opened) EXPECT_THAT(types, HasSubstr("<mime-type type=\"" + one + "\">"));
    const std::regex defined("<mime-type type=\"([^\"]*)\"");
    for (std::sregex_iterator one(types.begin(), types.end(), defined), end; one != end; ++one)
        EXPECT_TRUE(opened.contains((*one)[1])) << (*one)[1];
}

TEST(ProgramsWithoutTests, AreConfiguredWithoutTheTestsFolderAndWhatItNeeds) {
    const TemporaryFolder folder;
    const fs::path copy = folder / "source";
    fs::create_directories(copy);
    for (const char* part :
         {"app", "cmake", "core", "docs", "packaging", "resources", "robots", "translations", "transport",
          "widgets", "CMakeLists.txt", "README.md", "CHANGELOG.md"})
        fs::copy(source() / part, copy / part, fs::copy_options::recursive);
    const fs::path build = folder / "build";
    const ProcessOutcome run =
        runProcess("/usr/bin/env", {"cmake", "-G", "Ninja", "-S", copy.string(), "-B", build.string(),
                                    "-DLEITSTAND_TESTS=OFF", "-DCMAKE_DISABLE_FIND_PACKAGE_GTest=ON",
                                    "-DCMAKE_DISABLE_FIND_PACKAGE_benchmark=ON",
                                    "-DCMAKE_DISABLE_FIND_PACKAGE_nanoflann=ON"});
    ASSERT_EQ(run.exitCode, 0) << run.out << run.err;
    const std::string cache = readText(build / "CMakeCache.txt");
    EXPECT_THAT(cache, Not(HasSubstr("GTEST")));
    EXPECT_THAT(cache, Not(HasSubstr("LIBAVFORMAT")));
    const std::string rules = readText(build / "build.ninja");
    EXPECT_THAT(rules, HasSubstr("bin/leitstandctl"));
    EXPECT_THAT(rules, Not(HasSubstr("/tests/")));
    EXPECT_THAT(rules, Not(HasSubstr("gtest")));
}

}  // namespace
}  // namespace leitstand::test
