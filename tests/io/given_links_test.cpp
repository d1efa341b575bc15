#include "core/io/graph/given_links.h"

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

TEST(GivenLinks, AreAPoseOrARefusalALine) {
    const TemporaryFolder folder;
    const auto read = readGivenLinks(written(
        folder / "hand.txt", "# i j tx ty tz qx qy qz qw\r\n3 17 1 2 3 0 0 0.7071 0.7071\n\n 4 5 no"));
    ASSERT_TRUE(read.ok()) << errorOf(read);
    ASSERT_EQ(read->size(), 2U);
    EXPECT_EQ(read->front().from, 3U);
    EXPECT_EQ(read->front().to, 17U);
    ASSERT_TRUE(read->front().toInFrom);
    EXPECT_TRUE(read->front().toInFrom->isApprox(poseFrom({1, 2, 3}, 0, 0, degrees(90)), 1e-12));
    EXPECT_EQ(read->back().from, 4U);
    EXPECT_FALSE(read->back().toInFrom) << "not the same place";
    EXPECT_TRUE(readGivenLinks(written(folder / "none.txt", "# nothing yet\n"))->empty());
}

TEST(GivenLinks, NameFileLineAndExpectationOfWhatCannotBeRead) {
    const TemporaryFolder folder;
    const auto errorFor = [&](const std::string& content) {
        return errorOf(readGivenLinks(written(folder / "hand.txt", content)));
    };
    const char* const lines = "expected i j tx ty tz qx qy qz qw, or i j no";
    EXPECT_THAT(errorFor("1 2 no\n1 2\n"), HasSubstr(std::string("hand.txt:2: ") + lines));
    EXPECT_THAT(errorFor("1 2 no way\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("-1 2 no\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("1 2.5 no\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("99999999999999999999999 2 no\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("1 2 0 0 0 0 0 0\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("1 2 0 0 0 0 0 0 1 7\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("1 2 0 nan 0 0 0 0 1\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("1 2 0 inf 0 0 0 0 1\n"), HasSubstr(lines));
    EXPECT_THAT(errorFor("1 2 0 0 1e300 0 0 0 1\n"), HasSubstr("a position within 100 km"));
    EXPECT_THAT(errorFor("1 2 0 0 0 0 0 0 0\n"), HasSubstr("a quaternion of length 1"));
    EXPECT_THAT(errorOf(readGivenLinks(folder / "missing.txt")), HasSubstr("missing.txt"));
}

}  // namespace
}  // namespace leitstand
