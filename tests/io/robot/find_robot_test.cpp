#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/robot/shipped_robots.h"
#include "tests/io/robot/robot_texts.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

TEST(FindRobotFile, TakesPathsAsTheyAre) {
    const TemporaryFolder folder;
    writeText(folder / "mine", "x");
    EXPECT_EQ(findRobotFile((folder / "mine").string(), {}).value(), folder / "mine");
    EXPECT_EQ(findRobotFile("robots/k.yaml", {}).value(), "robots/k.yaml") << "reading it tells more";
    EXPECT_EQ(findRobotFile("k.yaml", {}).value(), "k.yaml");
}

TEST(FindRobotFile, TakesTheFirstFolderThatKnowsAName) {
    const TemporaryFolder mine, shipped;
    writeText(mine / "kurt3d.yaml", "x");
    writeText(shipped / "kurt3d.yaml", "x");
    writeText(shipped / "crawler.yaml", "x");
    const std::vector<std::filesystem::path> both = {mine.path(), shipped.path()};
    EXPECT_EQ(findRobotFile("kurt3d", both).value(), mine / "kurt3d.yaml");
    EXPECT_EQ(findRobotFile("crawler", both).value(), shipped / "crawler.yaml");
    EXPECT_THAT(shippedRobots(both), testing::ElementsAre("crawler", "kurt3d"));
    EXPECT_EQ(
        findRobotFile("crowler", both).error().text,
        "crowler: expected a robot's file, or the name crawler or kurt3d, found none, did you mean crawler?");
    EXPECT_EQ(findRobotFile("x", {mine / "none"}).error().text, "x: expected a robot's file, found none");
}

/// This test stands in bin/ like the programs.
TEST(FindRobotFile, KnowsTheRobotsThatCameWithTheProgram) {
    const auto names = shippedRobots({ShippedRobots});
    EXPECT_GE(names.size(), 3U);
    for (const std::string& name : names) {
        const auto file = findRobotFile(name, {robotFolders().back()});
        ASSERT_TRUE(file.ok()) << file.error().text;
        EXPECT_TRUE(std::filesystem::exists(*file)) << *file;
    }
}

}  // namespace
}  // namespace leitstand::test
