// The same mission makes the same bytes: wherever it lies, however it is called, and as often as one asks.
#include <filesystem>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/app/report/foreign_bag.h"
#include "tests/app/report/sample_mission.h"
#include "tests/support/places.h"
#include "tests/support/process.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

/// Writes a report of @p mission, as it is called in the folder @p from, and gives what is in its files.
std::map<std::string, std::string> bytesOf(const fs::path& from, const std::string& mission,
                                           const fs::path& out) {
    const std::string command =
        fmt::format("cd '{}' && SOURCE_DATE_EPOCH=1700000000 '{}' report '{}' --out '{}'", from.string(),
                    program("leitstandctl"), mission, out.string());
    const ProcessOutcome made = runProcess("/bin/sh", {"-c", command});
    EXPECT_EQ(made.exitCode, 0) << made.err;
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::directory_iterator(out))
        files[entry.path().filename().string()] = readText(entry.path());
    return files;
}

void expectSame(const std::map<std::string, std::string>& first,
                const std::map<std::string, std::string>& again, const std::string& what) {
    EXPECT_EQ(first.size(), again.size()) << what;
    for (const auto& [name, bytes] : first) {
        const auto other = again.find(name);
        ASSERT_NE(other, again.end()) << what << ": " << name;
        EXPECT_TRUE(bytes == other->second) << what << ": " << name;
    }
}

TEST(SteadyBytes, OfADamagedMissionThatIsCalledByOtherPathsAndLiesElsewhere) {
    const TemporaryFolder folder;
    const fs::path home = folder / "home", elsewhere = folder / "some where" / "else";
    writeSampleMission(home / "final");
    const fs::path log = home / "final" / "final_0.db3";
    fs::resize_file(log, fs::file_size(log) * 3 / 4);
    fs::create_directories(elsewhere);
    fs::copy(home / "final", elsewhere / "final", fs::copy_options::recursive);
    const auto first = bytesOf(home, "final", folder / "out0");
    EXPECT_GE(first.size(), 7U);
    int number = 0;
    const auto compare = [&](const fs::path& from, const std::string& mission) {
        expectSame(first, bytesOf(from, mission, folder / fmt::format("out{}", ++number)), mission);
    };
    compare(home, (home / "final").string());
    compare(home, "./final/");
    compare(home / "final", ".");
    compare(folder.path(), "home/../home/final");
    compare(elsewhere, (elsewhere / "final").string());
}

TEST(SteadyBytes, OfABagOfOthersThatIsRegisteredTwice) {
    const TemporaryFolder folder;
    ForeignBag(folder / "rover").drive();
    expectSame(bytesOf(folder.path(), "rover", folder / "first"),
               bytesOf(folder.path(), (folder / "rover").string(), folder / "second"), "registered again");
}

TEST(SteadyBytes, OfTheShippedSample) {
    const TemporaryFolder folder;
    const fs::path samples = fs::path(sourceFolder()) / "resources/samples";
    expectSame(bytesOf(samples, "yellow-7", folder / "first"),
               bytesOf(folder.path(), (samples / "yellow-7").string(), folder / "second"), "the sample");
}

}  // namespace
}  // namespace leitstand::test
