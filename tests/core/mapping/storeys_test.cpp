#include "core/mapping/storeys.h"

#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace leitstand::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// Scans of robots that drive, each seeing a patch of floor.
class Storeys : public testing::Test {
protected:
    /// A scanner that stands @p above the floor, which is at @p floor [m].
    void scan(double floor, double above = 0.9, bool uncertain = false) {
        auto scan = std::make_shared<Scan>();
        for (int i = 0; i < 50; ++i) {
            const float x = 0.3F + 0.1F * static_cast<float>(i);
            scan->points.emplace_back(x, 0.0F, static_cast<float>(-above));
            scan->labels.push_back(Label::Floor);
            scan->points.emplace_back(x, 1.0F, 0.5F);
            scan->labels.push_back(Label::Wall);
        }
        MapScan one;
        one.scan = scan;
        one.uncertain = uncertain;
        one.poseInMap = poseFrom({0.5 * static_cast<double>(m_map.scans.size()), 0, floor + above}, 0, 0, 0);
        m_map.scans.push_back(one);
    }
    void level(double floor, int scans, double above = 0.9) {
        for (int i = 0; i < scans; ++i) scan(floor + 0.02 * (i % 3 - 1), above);
    }
    /// A way that rises evenly.
    void ramp(double from, double to, int scans) {
        for (int i = 1; i <= scans; ++i) scan(from + (to - from) * i / (scans + 1));
    }

    Map m_map;
};

TEST_F(Storeys, AMapWithoutScansHasNoneAndAnArenaWithRampsOne) {
    EXPECT_THAT(storeysOf(m_map), IsEmpty());
    for (int i = 0; i < 30; ++i) scan(0.25 * (i % 3), i % 2 == 0 ? 0.9 : 0.3);
    ASSERT_THAT(storeysOf(m_map), SizeIs(1));
    EXPECT_EQ(storeysOf(m_map).front().number, 0);
    EXPECT_NEAR(storeysOf(m_map).front().floor, 0.25, 0.3);
}

TEST_F(Storeys, AreCountedFromTheOneWhereTheMapBeginsAndRampsAreNone) {
    level(0.0, 60);
    ramp(0.0, 2.6, 26);
    level(2.6, 40, 0.3);
    ramp(2.6, 0.0, 26);
    ramp(0.0, -3.4, 30);
    level(-3.4, 50);
    const std::vector<Storey> storeys = storeysOf(m_map);
    ASSERT_THAT(storeys, SizeIs(3));
    EXPECT_EQ(storeys[0].number, -1);
    EXPECT_EQ(storeys[1].number, 0);
    EXPECT_EQ(storeys[2].number, 1);
    EXPECT_NEAR(storeys[0].floor, -3.4, 0.1);
    EXPECT_NEAR(storeys[1].floor, 0.0, 0.1);
    EXPECT_NEAR(storeys[2].floor, 2.6, 0.1) << "of its floor, whatever robot's scanner saw it";
}

TEST_F(Storeys, OneIsThereOnlyAfterSomeScans) {
    level(0.0, 40);
    ramp(0.0, 2.6, 8);
    level(2.6, 2);
    EXPECT_THAT(storeysOf(m_map), SizeIs(1));
    level(2.6, 10);
    EXPECT_THAT(storeysOf(m_map), SizeIs(2));
    level(0.0, 900);
    EXPECT_THAT(storeysOf(m_map), SizeIs(2)) << "and it stays, however much comes elsewhere";
}

TEST_F(Storeys, WhatDoesNotFitCountsNot) {
    level(0.0, 40);
    for (int i = 0; i < 30; ++i) scan(4.0, 0.9, true);
    EXPECT_THAT(storeysOf(m_map), SizeIs(1));
}

TEST_F(Storeys, HeightsOfOneEndWhereTheNextBegins) {
    const std::vector<Storey> storeys = {{-1, -3.0}, {0, 0.0}};
    EXPECT_DOUBLE_EQ(*heightsOf(storeys, 0).to, heightsOf(storeys, 1).from);
    EXPECT_LT(heightsOf(storeys, 0).from, -3.3) << "what lies a little lower belongs to it";
    EXPECT_LT(heightsOf(storeys, 1).from, -0.3);
    EXPECT_FALSE(heightsOf(storeys, 1).to);
}

TEST(StoreyShares, TogetherHaveAllHeights) {
    const std::vector<Storey> storeys = {{-1, -3.0}, {0, 0.0}, {1, 2.6}};
    const std::vector<StoreyShare> shares = sharesOf(storeys);
    ASSERT_THAT(shares, SizeIs(3));
    for (const double z : {-1e6, -20.0, -3.0, -0.7, -0.6, 0.0, 1.9, 2.1, 2.6, 40.0}) {
        int holding = 0;
        for (const StoreyShare& share : shares) holding += share.heights.hold(z) ? 1 : 0;
        EXPECT_EQ(holding, 1) << z;
        EXPECT_TRUE(shares[shareAt(shares, z)].heights.hold(z)) << z;
    }
    EXPECT_EQ(shares[shareAt(shares, 0.0)].number, 0);
    EXPECT_EQ(shares[shareAt(shares, 1.9)].number, 0) << "a ramp is the storey's that it leads up from";
    ASSERT_THAT(sharesOf({}), SizeIs(1)) << "of a map that has none";
    EXPECT_TRUE(sharesOf({}).front().heights.hold(1e9));
}

TEST(StoreyShares, HaveNames) {
    EXPECT_EQ(storeyName(0), "0");
    EXPECT_EQ(storeyName(2), "+2");
    EXPECT_EQ(storeyName(-1), "\u22121");
}

}  // namespace
}  // namespace leitstand::test
