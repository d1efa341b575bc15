#include <filesystem>

#include <gtest/gtest.h>

#include "core/io/bag/bag_reader.h"
#include "tests/app/recording.h"
#include "tests/app/soak/station_process.h"
#include "tests/support/hanging_library.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

// Leaving the domain waits for the library's threads for ever, and would keep window and log open.
TEST(StationEnd, AStationWhoseLibraryHangsEndsWithinFiveSecondsAndItsLogIsWhole) {
    const TestDomain domain;
    const TemporaryFolder folder;
    const ChildProcess robot(program("leitstand-robot"),
                             {"kurt3d", "--arena", "yellow", "--seed", "7", "--domain",
                              std::to_string(domain.number()), "--interface", "lo"});
    StationProcess station(folder.path(), domain.number());
    ASSERT_TRUE(waitUntil([&] { return recordedOn(station.mission(), "/kurt3d/odom").size() > 20; }, 90s))
        << station.out();
    HangingLibrary hanging(station.id());
    ASSERT_GT(hanging.threads(), 1U);
    station.terminate();
    EXPECT_TRUE(hanging.endsWithin(5s)) << station.out();
    EXPECT_EQ(station.waitForEnd(), 1);
    const auto bag = BagReader::open(station.mission());
    ASSERT_TRUE(bag.ok()) << bag.error().text;
    EXPECT_TRUE((*bag)->problems().empty());
    for (const auto& file : std::filesystem::directory_iterator(station.mission()))
        EXPECT_FALSE(file.path().string().ends_with("-wal")) << file.path();
}

}  // namespace
}  // namespace leitstand::test
