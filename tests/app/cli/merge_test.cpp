#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/recording.h"
#include "tests/app/review/written_room.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Once around in the room, @p radius from its middle; backwards where @p turn is negative.
std::vector<Pose> around(double radius, double turn) {
    std::vector<Pose> places;
    for (int i = 0; i < 24; ++i) {
        const double angle = turn * degrees(15) * i;
        places.push_back(poseFrom({radius * std::cos(angle), radius * std::sin(angle), 0.9}, 0, 0,
                                  angle + turn * M_PI / 2));
    }
    return places;
}

class MergeCommand : public testing::Test {
protected:
    std::string write(const std::string& name, const std::vector<Pose>& places) const {
        WrittenMission mission(folder / name);
        double seconds = 1.0;
        (void)writeRoom(mission, places, seconds);
        return (folder / name).string();
    }

    const TemporaryFolder folder;
};

TEST_F(MergeCommand, TwoMissionsOfARoomAreOneMapInWhichNothingChanged) {
    const std::string monday = write("monday", around(1.8, 1.0)),
                      tuesday = write("tuesday", around(1.6, -1.0));
    const std::string both = (folder / "both").string();
    const auto merged = leitstandctl({"merge", monday, tuesday, "-o", both, "--json"});
    ASSERT_EQ(merged.exitCode, 0) << merged.err;
    const json reported = json::parse(merged.out);
    EXPECT_EQ(reported["first"], 24);
    EXPECT_EQ(reported["second"], 24);
    EXPECT_EQ(reported["together"], true);
    const auto changes = leitstandctl({"changes", both});
    EXPECT_EQ(changes.exitCode, 0) << changes.err;
    EXPECT_THAT(changes.out, HasSubstr("monday -> tuesday: 24 and 24 key scans"));
    EXPECT_THAT(changes.out, HasSubstr("nothing changed where both looked"));
    EXPECT_EQ(json::parse(leitstandctl({"changes", both, "--json"}).out)["later"], "tuesday");
    const auto again = leitstandctl({"merge", monday, tuesday, "-o", both});
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_THAT(again.err, HasSubstr("both: it is there already"));
}

TEST_F(MergeCommand, WhatItCannotDoIsToldWithTheMissionsName) {
    const std::string monday = write("monday", around(1.8, 1.0));
    const auto absent =
        leitstandctl({"merge", monday, (folder / "absent").string(), "-o", (folder / "x").string()});
    EXPECT_EQ(absent.exitCode, 1);
    EXPECT_THAT(absent.err, HasSubstr("absent"));
    EXPECT_FALSE(std::filesystem::exists(folder / "x"));
    const auto alone = leitstandctl({"changes", monday});
    EXPECT_EQ(alone.exitCode, 1);
    EXPECT_THAT(alone.err, HasSubstr("monday: expected a map of several missions"));
}

}  // namespace
}  // namespace leitstand::test
