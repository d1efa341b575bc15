#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/handin/search_list.h"
#include "tests/support/temporary_folder.h"

namespace leitstand::test {
namespace {

using testing::HasSubstr;

TEST(SearchList, ComesBackAsItWasWritten) {
    const TemporaryFolder folder;
    const std::vector<ListedSearch> rows = {
        {.sensor = "camera", .what = "reachable", .area = 20.0, .share = 1.0},
        {.sensor = "camera", .what = "seen", .area = 15.5, .share = 0.775},
        {.sensor = "camera", .what = "missed", .area = 4.25, .share = 0.2125, .x = -1.25, .y = 3.5}};
    ASSERT_TRUE(writeSearchList(folder / "a_searched.csv", rows));
    const auto read = readSearchList(folder / "a_searched.csv");
    ASSERT_TRUE(read) << read.error().text;
    ASSERT_EQ(read->size(), 3U);
    EXPECT_EQ(read->at(2).what, "missed");
    EXPECT_DOUBLE_EQ(read->at(2).x, -1.25);
    EXPECT_DOUBLE_EQ(read->at(2).y, 3.5);
    EXPECT_NEAR(read->at(1).share, 0.775, 1e-3);
}

TEST(SearchList, TellsOfStoreysWhereThereAreSeveral) {
    const TemporaryFolder folder;
    const std::vector<ListedSearch> rows = {
        {.sensor = "camera", .what = "seen", .area = 3.0, .share = 0.5},
        {.sensor = "camera", .what = "seen", .area = 2.0, .share = 0.4, .storey = 1},
        {.sensor = "camera", .what = "missed", .area = 1.0, .share = 0.2, .x = 1.5, .y = -2.5, .storey = -1}};
    ASSERT_TRUE(writeSearchList(folder / "s.csv", rows));
    const auto read = readSearchList(folder / "s.csv");
    ASSERT_TRUE(read) << read.error().text;
    ASSERT_EQ(read->size(), 3U);
    EXPECT_FALSE(read->at(0).storey) << "of all";
    EXPECT_EQ(read->at(1).storey, 1);
    EXPECT_EQ(read->at(2).storey, -1);
    EXPECT_DOUBLE_EQ(read->at(2).y, -2.5);
}

TEST(SearchList, WhatMakesNoSenseIsNamedWithItsLine) {
    const TemporaryFolder folder;
    const auto problem = [&](const std::string& text) {
        writeText(folder / "b.csv", text);
        const auto read = readSearchList(folder / "b.csv");
        return read ? std::string() : read.error().text;
    };
    const std::string head = "sensor,what,m2,percent,x,y\n";
    EXPECT_EQ(problem(head), "");
    EXPECT_THAT(problem(""), HasSubstr("the columns sensor,what"));
    EXPECT_THAT(problem("a,b\n"), HasSubstr("b.csv:1"));
    EXPECT_THAT(problem(head + "camera,seen,1\n"), HasSubstr("6 fields"));
    EXPECT_THAT(problem(head + "camera,seen,-1,2,,\n"), HasSubstr("b.csv:2"));
    EXPECT_THAT(problem(head + "camera,seen,nan,2,,\n"), HasSubstr("an area"));
    EXPECT_THAT(problem(head + "camera,missed,1,2,x,3\n"), HasSubstr("a number as x"));
    const std::string storeys = "sensor,what,m2,percent,x,y,storey\n";
    EXPECT_EQ(problem(storeys + "camera,seen,1,2,,,\ncamera,seen,1,2,,,-1\n"), "");
    EXPECT_THAT(problem(storeys + "camera,seen,1,2,,\n"), HasSubstr("7 fields"));
    EXPECT_THAT(problem(storeys + "camera,seen,1,2,,,1e300\n"), HasSubstr("a number as storey"));
    EXPECT_THAT(problem("sensor,what,m2,percent,x,y,floor\n"), HasSubstr("the columns"));
    EXPECT_FALSE(readSearchList(folder / "absent.csv"));
    EXPECT_FALSE(writeSearchList(folder / "c.csv", {{.sensor = "camera",
                                                     .what = "seen",
                                                     .area = std::numeric_limits<double>::quiet_NaN(),
                                                     .share = 0.0}}));
}

}  // namespace
}  // namespace leitstand::test
