#include "core/mapping/comparison/map_changes.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stop_token>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/visits.h"

namespace leitstand::test {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::Not;

std::vector<ReportScan> together(std::vector<ReportScan> first, const std::vector<ReportScan>& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// The room without furniture, and a day later with it, or the other way around.
std::vector<ReportScan> twoDays(bool firstFurnished, bool secondFurnished) {
    return together(scansOf({"kurt3d@monday", 0, firstFurnished, 1}),
                    scansOf({"kurt3d@tuesday", 1, secondFurnished, 4}));
}

TEST(MapChanges, VisitsAreMissionsAndTheNewestIsComparedWithAllBefore) {
    // A robot's clock may say anything.
    const auto scans = together(twoDays(false, false), scansOf({"kurt3d", -7000, false, 7}));
    const Visits visits = visitsOf(scans);
    EXPECT_EQ(visits.name, "") << "of this mission";
    EXPECT_THAT(visits.earlier, ElementsAre("monday", "tuesday"));
    EXPECT_THAT(visits.after, ElementsAre(7, 8, 9));
    EXPECT_THAT(visits.before, ElementsAre(1, 2, 3, 4, 5, 6));
}

TEST(MapChanges, AMapOfOneMissionHasNothingToCompare) {
    const auto scans = scansOf({"kurt3d", 0, true, 1});
    EXPECT_EQ(changesOf(scans).compared, 0U);
    EXPECT_THAT(changesOf(scans).things, IsEmpty());
    EXPECT_EQ(changesOf({}).compared, 0U);
}

TEST(MapChanges, WhatStoodThereTheSecondTimeAloneIsNew) {
    const MapChanges changes = changesOf(twoDays(false, true));
    EXPECT_EQ(changes.compared, 6U);
    ASSERT_THAT(changes.things, Not(IsEmpty()));
    EXPECT_THAT(changes.things, Each(Field(&ChangedThing::isNew, true)));
    for (const ChangedThing& thing : changes.things) {
        EXPECT_GE(thing.scan, 4U) << "seen on the second day";
        EXPECT_TRUE(Eigen::AlignedBox3d(Eigen::Vector3d(-4, -3, 0), Eigen::Vector3d(4, 3, 2.6))
                        .contains(thing.box.center()));
        for (const Eigen::Vector3f& cell : thing.cells) EXPECT_TRUE(thing.box.contains(cell.cast<double>()));
    }
    EXPECT_TRUE(std::is_sorted(
        changes.things.begin(), changes.things.end(),
        [](const ChangedThing& a, const ChangedThing& b) { return a.cells.size() > b.cells.size(); }));
}

TEST(MapChanges, TheOtherWayAroundTheSameIsGone) {
    const MapChanges came = changesOf(twoDays(false, true)), went = changesOf(twoDays(true, false));
    EXPECT_THAT(went.things, Each(Field(&ChangedThing::isNew, false)));
    EXPECT_NEAR(static_cast<double>(went.things.size()), static_cast<double>(came.things.size()), 1.0);
}

TEST(MapChanges, WhereNothingChangedNothingIsTold) {
    EXPECT_THAT(changesOf(twoDays(true, true)).things, IsEmpty());
    EXPECT_THAT(changesOf(twoDays(false, false)).things, IsEmpty());
}

TEST(MapChanges, WhatOneScanAloneLookedThroughMayBeNoise) {
    const auto scans =
        together(scansOf({"kurt3d@monday", 0, false, 1, 1}), scansOf({"kurt3d@tuesday", 1, true, 4}));
    EXPECT_THAT(changesOf(scans).things, IsEmpty());
}

TEST(MapChanges, WhatWasNotLookedAtBothTimesIsNotCompared) {
    auto scans = twoDays(false, true);
    for (ReportScan& scan : scans) {
        if (scan.id >= 4) scan.scanInMap.translation().x() += 50.0;  // another wing
    }
    EXPECT_EQ(changesOf(scans).compared, 0U) << "nothing is known, which is not nothing";
    EXPECT_THAT(changesOf(scans).things, IsEmpty());
}

TEST(MapChanges, PointsThatAreNowhereChangeNothing) {
    auto scans = twoDays(false, true);
    const std::size_t things = changesOf(scans).things.size();
    auto hostile = std::make_shared<Scan>(*scans.back().scan);
    constexpr float Most = std::numeric_limits<float>::max();
    for (const float far : {Most, -Most, 1e30F, 3e9F}) {
        hostile->points.emplace_back(far, 0.0F, 0.0F);
        hostile->points.emplace_back(0.0F, far, far);
        hostile->labels.insert(hostile->labels.end(), 2, Label::Wall);
    }
    scans.back().scan = hostile;
    EXPECT_EQ(changesOf(scans).things.size(), things);
}

TEST(MapChanges, CancelledNothingIsTold) {
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THAT(changesOf(twoDays(false, true), {}, {{}, stop.get_token()}).things, IsEmpty());
}

}  // namespace
}  // namespace leitstand::test
