#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/event/station_topics.h"
#include "tests/app/recording.h"
#include "tests/app/review/written_room.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// A mission whose scans lie off by some centimetres.
void writeUntidy(const std::filesystem::path& folder) {
    WrittenMission mission(folder);
    double seconds = 1.0;
    std::vector<ScanPose> poses = writeRoom(mission, alongTheRoom(), seconds);
    for (std::size_t i = 1; i < poses.size(); ++i)
        poses[i].scanInMap = poses[i].scanInMap * poseFrom({i % 2 == 0 ? 0.05 : -0.04, 0.03, 0}, 0, 0, 0);
    mission.publish(seconds, std::string(station_topic::ScanPoses),
                    ScanPosesSample{Time{}, "us", ScanPosesSample::Cause::Registration, poses});
}

TEST(TidyCommand, MovesScansTellsItAndTakesItBack) {
    const TemporaryFolder folder;
    const std::string mission = (folder / "mission").string();
    writeUntidy(mission);
    const auto run = leitstandctl({"tidy", mission, "--json"});
    ASSERT_EQ(run.exitCode, 0) << run.err;
    const json reported = json::parse(run.out);
    EXPECT_EQ(reported["scans"], 6);
    EXPECT_EQ(reported["moved"], 5);
    EXPECT_GT(reported["largest_shift"], 0.03);
    EXPECT_LT(reported["rms_after"], reported["rms_before"]);
    const auto again = leitstandctl({"tidy", mission});
    EXPECT_EQ(again.exitCode, 0) << again.err;
    EXPECT_THAT(again.out, HasSubstr("nothing moved noticeably, nothing was written"));
    EXPECT_EQ(leitstandctl({"tidy", mission, "--undo"}).exitCode, 0);
    const auto twice = leitstandctl({"tidy", mission, "--undo"});
    EXPECT_EQ(twice.exitCode, 1);
    EXPECT_THAT(twice.err, HasSubstr("mission: its map was not tidied"));
    EXPECT_EQ(json::parse(leitstandctl({"tidy", mission, "--json"}).out)["moved"], 5) << "it lay as before";
}

TEST(TidyCommand, NamesTheFolderThatIsNoMission) {
    const TemporaryFolder folder;
    const auto run = leitstandctl({"tidy", (folder / "absent").string()});
    EXPECT_EQ(run.exitCode, 1);
    EXPECT_THAT(run.err, HasSubstr("absent"));
}

}  // namespace
}  // namespace leitstand::test
