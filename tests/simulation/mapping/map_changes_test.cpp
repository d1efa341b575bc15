#include "core/mapping/comparison/map_changes.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/map_problem.h"
#include "tests/simulation/mapping/building_sets.h"
#include "tests/simulation/mapping/two_drives.h"

namespace leitstand::simulation::test {
namespace {

constexpr double From = 0.02, To = 0.45;  ///< of the ring, that is driven both times
constexpr double Near = 0.7;              ///< so near to a box that came or went a thing is that [m]

/// A box beside the way, at share @p at of the ring, @p aside of its middle, @p size wide and @p height high.
Element boxAt(const BuildingWays& ways, double at, double aside, double size, double height) {
    const std::vector<Eigen::Vector3d> way = stretch(ways, at, at + 0.01);
    const Eigen::Vector3d along = (way[1] - way[0]).normalized();
    Element box = elementOf(ElementKind::Wall);
    box.name = "box " + std::to_string(at);
    box.pose.translation() = way[0] + aside * Eigen::Vector3d::UnitZ().cross(along);
    box.size = {size, size, height};
    return box;
}

/// A drive along the same stretch, on the day @p day.
ScriptedDrive driveOf(const Building& building, bool back, std::uint64_t seed, int day) {
    ScriptSettings script;
    script.seed = seed;
    script.sensor = realScanner();
    const auto way = back ? stretch(building.ways, To, From) : stretch(building.ways, From, To);
    ScriptedDrive drive = scriptedDrive(building.arena, DrivePath(way), script);
    rename(drive, day == 0 ? "kurt3d@monday" : "kurt3d@tuesday");
    for (LiveScan& live : drive.scans) {
        Scan scan = *live.scan;
        scan.start += std::chrono::hours(24 * day);
        scan.end += std::chrono::hours(24 * day);
        live.scan = std::make_shared<const Scan>(std::move(scan));
    }
    return drive;
}

/// Where an arena's frame lies in a map whose first scan is of @p drive.
Pose arenaIn(const LiveMap& map, const ScriptedDrive& drive) {
    const LiveKeyScan& begin = map.scans.front();
    return begin.pose.scanInMap * begin.sensorInBase.inverse() *
           drive.drive.baseInArena(begin.scan->end).inverse();
}

/// The map of both, the second put where it is.
LiveMapPtr mapOf(const ScriptedDrive& first, const ScriptedDrive& second) {
    LiveMapper mapper("test", {});
    for (const char* robot : {"kurt3d@monday", "kurt3d@tuesday"})
        mapper.setBody(robot, {first.drive.robot.footprint, first.drive.robot.height});
    for (const ScriptedDrive* drive : {&first, &second}) {
        if (drive == &second) {
            const Time end = second.scans.front().scan->end - std::chrono::hours(24);
            mapper.place("kurt3d@tuesday", arenaIn(*mapper.map(), first) * second.drive.baseInArena(end));
        }
        for (const LiveScan& live : drive->scans) {
            (void)mapper.add(live, live.scan->end);
            if (const auto problem = mapper.problem()) (void)mapper.settle(solve(*problem), live.scan->end);
        }
    }
    return mapper.map();
}

struct Told {
    int right = 0, missed = 0, wrong = 0;
};

/// Compares @p things with the boxes that came and went.
Told judged(const std::vector<ChangedThing>& things, const std::vector<Element>& came,
            const std::vector<Element>& went, const Pose& arenaInMap) {
    Told told;
    std::vector<bool> known(things.size(), false);
    for (const auto* boxes : {&came, &went}) {
        for (const Element& box : *boxes) {
            Eigen::Vector3d middle = arenaInMap * box.pose.translation();
            middle.z() += 0.5 * box.size.z();
            bool found = false;
            for (std::size_t i = 0; i < things.size(); ++i) {
                const bool near = things[i].box.exteriorDistance(middle) < Near && things[i].size() < 2.0;
                if (!near || things[i].isNew != (boxes == &came)) continue;
                known[i] = found = true;
            }
            ++(found ? told.right : told.missed);
        }
    }
    for (std::size_t i = 0; i < things.size(); ++i) {
        if (known[i]) continue;
        ++told.wrong;
        const Eigen::Vector3d middle = arenaInMap.inverse() * things[i].box.center();
        std::printf("  wrong: %s, %zu cells, %.1f x %.1f x %.1f m at %.1f %.1f %.1f\n",
                    things[i].isNew ? "new" : "gone", things[i].cells.size(), things[i].box.sizes().x(),
                    things[i].box.sizes().y(), things[i].box.sizes().z(), middle.x(), middle.y(), middle.z());
    }
    return told;
}

TEST(MapChangesLong, WhatCameAndWentBetweenTwoDrivesIsToldAndNothingElse) {
    const int count = measuredBuildings(5);
    int right = 0, missed = 0, wrong = 0;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t seed = firstSeed(861) + static_cast<std::uint64_t>(i);
        BuildingSettings settings;
        settings.width = 30.0;
        settings.depth = 20.0;
        Building monday = std::move(generateBuilding(settings, seed)).value(), tuesday = monday;
        std::vector<Element> went, came;
        for (const double at : {0.06, 0.17, 0.31}) went.push_back(boxAt(monday.ways, at, 0.7, 0.5, 0.8));
        for (const double at : {0.1, 0.24, 0.37}) came.push_back(boxAt(monday.ways, at, -0.7, 0.4, 1.2));
        for (const Element& box : went) monday.arena.elements.push_back(box);
        for (const Element& box : came) tuesday.arena.elements.push_back(box);
        const ScriptedDrive first = driveOf(monday, false, seed, 0);
        const ScriptedDrive second = driveOf(tuesday, true, seed + 5000, 1);
        const LiveMapPtr map = mapOf(first, second);
        std::vector<ReportScan> scans;
        for (const LiveKeyScan& scan : map->scans) {
            if (scan.counts()) scans.push_back({scan.id, scan.scan, scan.pose.scanInMap, scan.sensorInBase});
        }
        const Visits visits = visitsOf(scans);
        EXPECT_EQ(visits.name, "tuesday");
        const auto began = std::chrono::steady_clock::now();
        const std::vector<ChangedThing> things = changesBetween(scans, visits);
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
        const Told told = judged(things, came, went, arenaIn(*map, first));
        std::printf("changes %llu: %d of %zu told, %d wrong, %zu and %zu scans, %.1f s\n",
                    static_cast<unsigned long long>(seed), told.right, came.size() + went.size(), told.wrong,
                    visits.before.size(), visits.after.size(), seconds);
        right += told.right;
        missed += told.missed;
        wrong += told.wrong;
    }
    EXPECT_GE(right, 0.9 * (right + missed));
    EXPECT_LE(wrong, 0.1 * right);
}

}  // namespace
}  // namespace leitstand::simulation::test
