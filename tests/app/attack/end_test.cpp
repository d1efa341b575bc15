#include <csignal>

#include <gtest/gtest.h>

#include "tests/app/recording.h"
#include "tests/support/hanging_library.h"
#include "tests/support/temporary_folder.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

// Leaving the domain waits for the library's threads for ever, and would keep the log open.
TEST(End, ARecorderWhoseLibraryHangsEndsWithinFiveSecondsAndItsLogIsWhole) {
    const TestDomain domain;
    const TemporaryFolder folder;
    const std::string number = std::to_string(domain.number());
    const ChildProcess robot(program("leitstand-robot"), {"kurt3d", "--arena", "yellow", "--seed", "7",
                                                          "--domain", number, "--interface", "lo"});
    ChildProcess recorder(program("leitstandctl"),
                          {"record", "--out", (folder / "mission").string(), "--robot", "kurt3d", "--domain",
                           number, "--interface", "lo"});
    ASSERT_TRUE(waitUntil([&] { return recordedOn(folder / "mission", "/kurt3d/odom").size() > 20; }, 60s))
        << recorder.out();
    HangingLibrary hanging(recorder.id());
    ASSERT_GT(hanging.threads(), 1U);
    recorder.signal(SIGTERM);
    EXPECT_TRUE(hanging.endsWithin(5s)) << recorder.out();
    EXPECT_EQ(recorder.wait(), 1);
    EXPECT_NE(recorder.out().find("events,"), std::string::npos) << recorder.out();  // the summary
    const auto bag = must(BagReader::open(folder / "mission"));
    EXPECT_TRUE(bag->problems().empty());
    for (const auto& file : std::filesystem::directory_iterator(folder / "mission"))
        EXPECT_FALSE(file.path().string().ends_with("-wal")) << file.path();
}

TEST(End, ARobotWhoseLibraryHangsEndsWithinFiveSeconds) {
    const TestDomain domain;
    ChildProcess robot(program("leitstand-robot"), {"kurt3d", "--arena", "yellow", "--seed", "7", "--domain",
                                                    std::to_string(domain.number()), "--interface", "lo"});
    ASSERT_TRUE(waitUntil([&] { return robot.out().find("is in") != std::string::npos; }, 60s))
        << robot.out();
    HangingLibrary hanging(robot.id());
    ASSERT_GT(hanging.threads(), 1U);
    robot.signal(SIGTERM);
    EXPECT_TRUE(hanging.endsWithin(5s));
    EXPECT_NE(robot.wait(), 0);
}

}  // namespace
}  // namespace leitstand::test
