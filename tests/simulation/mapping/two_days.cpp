#include "tests/simulation/mapping/two_days.h"

#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "tests/simulation/mapping/two_drives.h"

namespace leitstand::simulation::test {
namespace {

constexpr double From = 0.02, To = 0.45;  ///< of the ring, that is driven both times
constexpr std::chrono::hours Day(24);
constexpr double Near = 0.7;  ///< so near to a box that came or went a thing is that [m]

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

/// A drive along the stretch, @p days later than the first one.
ScriptedDrive driveOf(const Building& building, bool back, std::uint64_t seed, int days) {
    ScriptSettings script;
    script.seed = seed;
    script.sensor = realScanner();
    const auto way = back ? stretch(building.ways, To, From) : stretch(building.ways, From, To);
    ScriptedDrive drive = scriptedDrive(building.arena, DrivePath(way), script);
    const std::chrono::nanoseconds later = days * Day;
    for (LiveScan& live : drive.scans) {
        Scan scan = *live.scan;
        scan.start += later;
        scan.end += later;
        live.scan = std::make_shared<const Scan>(std::move(scan));
    }
    return drive;
}

}  // namespace

Pose TwoDays::baseInArena(const Scan& scan) const {
    const bool later = scan.end >= second.scans.front().scan->end;
    return later ? second.drive.baseInArena(scan.end - Day) : first.drive.baseInArena(scan.end);
}

TwoDays twoDays(std::uint64_t seed) {
    BuildingSettings settings;
    settings.width = 30.0;
    settings.depth = 20.0;
    Building monday = std::move(generateBuilding(settings, seed)).value(), tuesday = monday;
    TwoDays days;
    for (const double at : {0.06, 0.17, 0.31}) days.went.push_back(boxAt(monday.ways, at, 0.7, 0.5, 0.8));
    for (const double at : {0.1, 0.24, 0.37}) days.came.push_back(boxAt(monday.ways, at, -0.7, 0.4, 1.2));
    for (const Element& box : days.went) monday.arena.elements.push_back(box);
    for (const Element& box : days.came) tuesday.arena.elements.push_back(box);
    days.first = driveOf(monday, false, seed, 0);
    days.second = driveOf(tuesday, true, seed + 5000, 1);
    return days;
}

ToldChanges judged(const std::vector<ChangedThing>& things, const TwoDays& days, const Pose& arenaInMap) {
    ToldChanges reported;
    std::vector<bool> known(things.size(), false);
    for (const auto* boxes : {&days.came, &days.went}) {
        for (const Element& box : *boxes) {
            Eigen::Vector3d middle = arenaInMap * box.pose.translation();
            middle.z() += 0.5 * box.size.z();
            bool found = false;
            for (std::size_t i = 0; i < things.size(); ++i) {
                const bool near =
                    things[i].box.exteriorDistance(middle) < Near && things[i].box.sizes().maxCoeff() < 2.0;
                if (!near || things[i].isNew != (boxes == &days.came)) continue;
                known[i] = found = true;
            }
            ++(found ? reported.right : reported.missed);
        }
    }
    for (std::size_t i = 0; i < things.size(); ++i) {
        if (known[i]) continue;
        ++reported.wrong;
        const Eigen::Vector3d middle = arenaInMap.inverse() * things[i].box.center();
        std::printf("  wrong: %s, %zu cells, %.1f x %.1f x %.1f m at %.1f %.1f %.1f\n",
                    things[i].isNew ? "new" : "gone", things[i].cells.size(), things[i].box.sizes().x(),
                    things[i].box.sizes().y(), things[i].box.sizes().z(), middle.x(), middle.y(), middle.z());
    }
    return reported;
}

}  // namespace leitstand::simulation::test
