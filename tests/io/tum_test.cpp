#include "core/io/clouds/tum.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/io/file_checks.h"

namespace leitstand {
namespace {

using test::errorOf;
using test::TemporaryFolder;
using test::written;
using ::testing::HasSubstr;

TEST(Tum, RoundTripsPosesAndTimesToTheNanosecond) {
    const TemporaryFolder folder;
    const Time now{std::chrono::nanoseconds(1'700'000'000'123'456'789)};
    const Time before{std::chrono::nanoseconds(-1'500'000'001)};
    const std::vector<TimedPose> poses = {{before, poseFrom({1, 2, 3}, 0.1, 0.2, 3.0)},
                                          {now, poseFrom({-1, 0.1, 1e-7}, -3.0, 1.5, -0.1)}};
    ASSERT_TRUE(writeTum(folder / "a.tum", poses).ok());
    const auto back = readTum(folder / "a.tum");
    ASSERT_TRUE(back.ok()) << errorOf(back);
    ASSERT_EQ(back->size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ((*back)[i].time, poses[i].time);
        EXPECT_TRUE((*back)[i].pose.isApprox(poses[i].pose, 1e-12));
    }
}

TEST(Tum, ReadsWhatOtherToolsWrite) {
    const TemporaryFolder folder;
    const auto read = readTum(
        written(folder / "a.tum",
                "# timestamp tx ty tz qx qy qz qw\r\n1.5e9 1 2 3 0 0 0.7071 0.7071\r\n\r\n7 0 0 0 0 0 0 1"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    ASSERT_EQ(read->size(), 2U);
    EXPECT_EQ(read->front().time, Time(std::chrono::seconds(1'500'000'000)));
    EXPECT_TRUE(read->front().pose.isApprox(poseFrom({1, 2, 3}, 0, 0, degrees(90)), 1e-12));
    EXPECT_EQ(read->back().time, Time(std::chrono::seconds(7)));
}

TEST(Tum, NamesFileLineAndExpectationOfWhatItCannotRead) {
    const TemporaryFolder folder;
    const auto errorFor = [&](const std::string& content) {
        return errorOf(readTum(written(folder / "a.tum", content)));
    };
    EXPECT_THAT(errorFor(""), HasSubstr("a.tum: expected poses, found none"));
    EXPECT_THAT(errorFor("0 0 0 0 0 0 0 1\n0 1 2 3 0 0 0\n"),
                HasSubstr("a.tum:2: expected t x y z qx qy qz qw"));
    EXPECT_THAT(errorFor("0 1 2 3 0 0 0 1 9\n"), HasSubstr(":1: expected t x y z"));
    EXPECT_THAT(errorFor("now 1 2 3 0 0 0 1\n"), HasSubstr(":1: expected t x y z"));
    EXPECT_THAT(errorFor("1e300 1 2 3 0 0 0 1\n"), HasSubstr(":1: expected t x y z"));
    EXPECT_THAT(errorFor("99999999999999999999 1 2 3 0 0 0 1\n"), HasSubstr(":1: expected t x y z"));
    EXPECT_THAT(errorFor("0 1 2 nan 0 0 0 1\n"), HasSubstr(":1: expected t x y z"));
    EXPECT_THAT(errorFor("0 1 2 1e300 0 0 0 1\n"), HasSubstr(":1: expected a position within 100 km"));
    EXPECT_THAT(errorFor("0 1 2 3 0 0 0 0\n"), HasSubstr(":1: expected a quaternion of length 1"));
    EXPECT_THAT(errorFor("0 1 2 3 0 0 0 1.02\n"), HasSubstr(":1: expected a quaternion of length 1"));
    EXPECT_THAT(errorFor("0 1 2 3 1e200 0 0 1e200\n"), HasSubstr(":1: expected a quaternion of length 1"));
    EXPECT_THAT(errorOf(readTum(folder.path())), HasSubstr("expected a file, found a directory"));
}

TEST(Tum, ReportsWhatCannotBeWritten) {
    const TemporaryFolder folder;
    EXPECT_THAT(errorOf(writeTum(folder / "no/a.tum", {{}})),
                HasSubstr("a.tum: cannot be written: No such file"));
    EXPECT_THAT(errorOf(writeTum(folder.path(), {{}})),
                HasSubstr("cannot be written: it is not a regular file"));
}

}  // namespace
}  // namespace leitstand
