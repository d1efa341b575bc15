// A report of a map with several storeys tells each of them.
#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/find_sample.h"
#include "core/handin/report_model.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/fold.h"
#include "tests/core/handin/report_scene.h"

namespace leitstand::test {
namespace {

using State = OccupancyGrid::State;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr int Scans = 5;  ///< of each storey

/// Rooms above each other, V1 and Q1 at the same place of both.
ReportInput twoRooms() {
    ReportInput input;
    input.robots = {"kurt3d"};
    input.scans = storeyScans(Scans);
    const auto file = [&](FindSample::Kind kind, double z) {
        FindSample find;
        find.kind = kind;
        find.number = 1;
        find.status = FindSample::Status::Confirmed;
        find.positionInMap = {1.5, 1.0, z};
        Event event;
        event.sequence = input.state.sequence + 1;
        event.topic = "/leitstand/victims";
        event.sample = find;
        input.state = fold(std::move(input.state), event);
    };
    file(FindSample::Kind::Victim, 0.4);
    file(FindSample::Kind::Code, 3.6);
    return input;
}

std::vector<std::string> namesOf(const std::vector<MapMark>& marks) {
    std::vector<std::string> names;
    for (const MapMark& mark : marks) names.push_back(nameOf(mark));
    return names;
}

TEST(ReportStoreys, AMapOfOneIsToldAsBefore) {
    ReportInput input;
    input.robots = {"kurt3d"};
    input.scans = roomScans(Scans);
    const ReportModel model = reportOf(input);
    EXPECT_THAT(model.storeys, IsEmpty());
    ASSERT_THAT(mapsOf(model), SizeIs(2));
    EXPECT_FALSE(mapsOf(model).front().storey);
    EXPECT_NEAR(model.explored, exploredArea(model.grids.front()), 1e-9);
}

TEST(ReportStoreys, EachHasItsOwnMapWithWhatIsOnIt) {
    const ReportModel model = reportOf(twoRooms());
    ASSERT_THAT(model.storeys, SizeIs(2));
    EXPECT_EQ(model.storeys[0].share.number, 0);
    EXPECT_EQ(model.storeys[1].share.number, 1);
    ASSERT_THAT(mapsOf(model), SizeIs(4)) << "each at both heights";
    EXPECT_THAT(namesOf(marksOf(model, 0)), ElementsAre("V1"));
    EXPECT_THAT(namesOf(marksOf(model, 1)), ElementsAre("Q1"));
    EXPECT_THAT(namesOf(marksOf(model)), ElementsAre("V1", "Q1"));
    EXPECT_NEAR(model.finds[0].aboveFloor, 0.4, 0.05);
    EXPECT_NEAR(model.finds[1].aboveFloor, 0.6, 0.05) << "above the floor that bears it";
    ReportInput below;
    below.robots = {"kurt3d"};
    below.scans = roomScans(Scans);
    const ReportModel alone = reportOf(below);
    for (const ReportStorey& storey : model.storeys) {
        const OccupancyGrid& map = storey.grids.front();
        std::size_t same = 0, walls = 0;
        for (double x = -4.1; x < 4.1; x += 0.05) {
            for (double y = -3.1; y < 3.1; y += 0.05) {
                if (alone.grids.front().at(x, y).state != State::Occupied) continue;
                ++walls;
                same += map.at(x, y).state == State::Occupied ? 1U : 0U;
            }
        }
        EXPECT_GT(walls, 500U);
        EXPECT_GT(static_cast<double>(same), 0.9 * static_cast<double>(walls))
            << "storey " << storey.share.number << " as the room alone";
        EXPECT_NEAR(storey.explored, alone.explored, 0.05 * alone.explored);
    }
    EXPECT_NEAR(model.explored, model.storeys[0].explored + model.storeys[1].explored, 1e-9);
}

TEST(ReportStoreys, WhereOdometryEndedScansTellWhereTheRobotWas) {
    ReportInput input = twoRooms();
    std::vector<PathPose>& odometry = input.odometry["kurt3d"];
    for (int i = 0; i <= 20; ++i)  // of the lower room alone
        odometry.push_back({Time(std::chrono::milliseconds(100'000 + 1'000 * i)),
                            poseFrom({-1.0 + 0.1 * i, 0, 0}, 0, 0, 0)});
    const ReportModel model = reportOf(input);
    ASSERT_THAT(model.storeys, SizeIs(2));
    EXPECT_EQ(model.finds[1].storey, 1);
    EXPECT_NEAR(model.finds[1].aboveFloor, 0.6, 0.05);
    EXPECT_GT(model.storeys[1].search.reachable, 15.0);
    const MapDrawing above = drawingOf(model, {0, 1}, "");
    ASSERT_FALSE(above.paths.empty());
    EXPECT_EQ(above.paths.back().size(), std::size_t{Scans}) << "a way, as far as scans tell it";
}

TEST(ReportStoreys, AFindWithoutAPlaceIsOnNone) {
    ReportInput input = twoRooms();
    FindSample lost;
    lost.number = 2;
    lost.positionInMap.setConstant(std::numeric_limits<double>::quiet_NaN());
    Event event;
    event.sequence = input.state.sequence + 1;
    event.topic = "/leitstand/victims";
    event.sample = lost;
    input.state = fold(std::move(input.state), event);
    const ReportModel model = reportOf(input);
    const auto found = std::find_if(model.finds.begin(), model.finds.end(),
                                    [](const ReportFind& find) { return find.name == "V2"; });
    ASSERT_NE(found, model.finds.end());
    EXPECT_FALSE(found->storey);
    EXPECT_THAT(namesOf(marksOf(model, 0)), ElementsAre("V1"));
}

TEST(ReportStoreys, ScansWithoutNumbersAreCountedFromTheFirst) {
    std::vector<ReportScan> scans = storeyScans(Scans);
    for (ReportScan& scan : scans) scan.id = 0;  // of a bag
    const std::vector<StoreyCoverage> storeys = coverageOf(scans, {}, groundOf(scans));
    ASSERT_THAT(storeys, SizeIs(2));
    EXPECT_EQ(storeys[0].storey.number, 0) << "it began below";
    EXPECT_EQ(storeys[1].storey.number, 1);
}

TEST(ReportStoreys, APathIsInTheMapOfTheStoreyThatItIsOn) {
    const ReportModel model = reportOf(twoRooms());
    const std::size_t all = model.robots.front().path.poses.size();
    std::size_t shown = 0;
    for (const ReportMap& map : mapsOf(model)) {
        if (map.band != 0) continue;
        const MapDrawing drawing = drawingOf(model, map, "");
        for (const auto& path : drawing.paths) shown += path.size();
        EXPECT_THAT(drawing.starts, SizeIs(map.storey == 0 ? 1 : 0)) << "it began on storey 0";
    }
    EXPECT_EQ(shown, all);
}

TEST(ReportStoreys, WhatWasSearchedIsToldOfEach) {
    const ReportModel model = reportOf(twoRooms());
    ASSERT_THAT(model.storeys, SizeIs(2));
    double reachable = 0.0, seen = 0.0;
    for (const ReportStorey& storey : model.storeys) {
        ASSERT_THAT(storey.search.sensors, SizeIs(1)) << "the scanner";
        EXPECT_GT(storey.search.reachable, 15.0);
        EXPECT_GT(storey.search.sensors.front().seen, 0.6 * storey.search.reachable);
        reachable += storey.search.reachable;
        seen += storey.search.sensors.front().seen;
    }
    EXPECT_NEAR(model.search.reachable, reachable, 1e-9);
    EXPECT_NEAR(model.search.sensors.front().seen, seen, 1e-9);
}

}  // namespace
}  // namespace leitstand::test
