#include "tests/simulation/mapping/building_sets.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <utility>

#include "core/base/time.h"
#include "tests/simulation/mapping/near_surfaces.h"
#include "tests/support/latency.h"

namespace leitstand::simulation::test {
namespace {

using leitstand::test::quantile;

std::vector<Eigen::Vector3d> around(const Eigen::AlignedBox2d& ring, double height) {
    const Eigen::Vector2d a = ring.min(), b = ring.max();
    return {{a.x(), a.y(), height}, {b.x(), a.y(), height}, {b.x(), b.y(), height}, {a.x(), b.y(), height}};
}

/// Key scans where the map has them at the end, and where they truly were. @p counting: without those that
/// are uncertain.
Trajectory finalPoses(const MappedDrive& mapped, const RecordedDrive& drive, bool counting) {
    Trajectory trajectory;
    for (const LiveKeyScan& key : mapped.map->scans) {
        if (counting && !key.counts()) continue;
        trajectory.found.push_back(key.pose.scanInMap * key.sensorInBase.inverse());
        trajectory.truth.push_back(drive.baseInArena(key.scan->end));
    }
    return trajectory;
}

/// How far finds are off in the end [m]: each victim that a robot came within 3 m of was taken down where the
/// nearest key scan saw it, and moves with that scan.
std::vector<double> findErrors(const Arena& arena, const Trajectory& keys, const Pose& mapInArena) {
    constexpr double Seen = 3.0;
    std::vector<double> errors;
    for (const Element& element : arena.elements) {
        if (element.kind != ElementKind::Victim) continue;
        const Eigen::Vector3d lies = element.pose.translation();
        const auto nearest =
            std::min_element(keys.truth.begin(), keys.truth.end(), [&](const Pose& a, const Pose& b) {
                return (a.translation() - lies).norm() < (b.translation() - lies).norm();
            });
        if (nearest == keys.truth.end() || (nearest->translation() - lies).norm() > Seen) continue;
        const Pose& found = keys.found[static_cast<std::size_t>(nearest - keys.truth.begin())];
        errors.push_back((mapInArena * (found * (nearest->inverse() * lies)) - lies).norm());
    }
    return errors;
}

/// Of key scans that count, each where @p baseInMap has it.
double surfaceErrorOf(const LiveMap& map, const NearSurfaces& surfaces, const Pose& mapInArena,
                      const std::vector<Pose>& baseInMap) {
    constexpr float Near = 6.0F;
    constexpr std::size_t Every = 23;
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < map.scans.size(); ++i) {
        const LiveKeyScan& key = map.scans[i];
        if (!key.counts()) continue;
        const Pose placed = mapInArena * baseInMap[i] * key.sensorInBase;
        for (std::size_t j = 0; j < key.scan->points.size(); j += Every) {
            const Eigen::Vector3f& point = key.scan->points[j];
            if (!(point.norm() < Near)) continue;
            squares += std::pow(surfaces.distance(placed * point.cast<double>()), 2);
            ++count;
        }
    }
    return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1)));
}

std::vector<Pose> entryOfKeys(const MappedDrive& mapped) {
    std::vector<Pose> poses;
    for (const LiveKeyScan& key : mapped.map->scans) {
        const auto of = std::find_if(mapped.localisations.begin(), mapped.localisations.end(),
                                     [&](const Localisation& one) { return one.keyScan == key.id; });
        poses.push_back(of->baseInMap);
    }
    return poses;
}

/// Median processor time of a scan while the map has about @p keyScans; 0: it never has [s].
double busyAbout(std::uint64_t keyScans, const MappedDrive& mapped) {
    constexpr std::uint64_t About = 50;
    std::vector<double> busy;
    for (std::size_t i = 0; i < mapped.busy.size(); ++i) {
        const std::uint64_t entered = mapped.localisations[i].keyScan;
        if (entered + About >= keyScans && entered <= keyScans + About) busy.push_back(mapped.busy[i]);
    }
    return busy.size() < About ? 0.0 : quantile(busy, 0.5);
}

/// BuildingRow::beside
double besideOf(const MappedDrive& mapped) {
    double busy = 0.0;
    for (const auto* const times : {&mapped.seeking, &mapped.solving, &mapped.settling})
        busy += std::accumulate(times->begin(), times->end(), 0.0);
    return busy / secondsBetween(mapped.scans.front().scan->start, mapped.scans.back().scan->end);
}

}  // namespace

std::vector<Eigen::Vector3d> ringRoute(const BuildingWays& ways, double laps) {
    const std::vector<Eigen::Vector3d> ring = around(ways.ring, 0.0);
    const double lap = 2.0 * ways.ring.sizes().sum();
    // From the middle of the southern side, so that it meets itself on a straight.
    std::vector<Eigen::Vector3d> route = {(ring[0] + ring[1]) / 2};
    double left = laps * lap;
    for (std::size_t next = 1; left > 0.0; next = (next + 1) % ring.size()) {
        const Eigen::Vector3d leg = ring[next] - route.back();
        route.push_back(route.back() + std::min(1.0, left / leg.norm()) * leg);
        left -= leg.norm();
    }
    return route;
}

std::vector<Eigen::Vector3d> eightRoute(const BuildingWays& ways, int loops) {
    const Eigen::Vector2d a = ways.ring.min(), b = ways.ring.max();
    // Up the cross corridor, back along one side of the ring.
    std::vector<Eigen::Vector3d> route = {{ways.cross, ways.ring.center().y(), 0.0}};
    for (int i = 0; i < loops; ++i) {
        const double side = i % 2 == 0 ? a.x() : b.x();
        route.emplace_back(ways.cross, b.y(), 0.0);
        route.emplace_back(side, b.y(), 0.0);
        route.emplace_back(side, a.y(), 0.0);
        route.emplace_back(ways.cross, a.y(), 0.0);
    }
    route.emplace_back(ways.cross, ways.ring.center().y(), 0.0);
    return route;
}

std::vector<Eigen::Vector3d> storeysRoute(const BuildingWays& ways) {
    const std::vector<Eigen::Vector3d>& ramp = ways.ramps.at(0);
    const double up = ramp.back().z();
    const std::vector<Eigen::Vector3d> ground = around(ways.ring, 0.0), above = around(ways.ring, up);
    // The ramp leads along the northern side, to the east where it rises along x.
    const bool east = ramp.back().x() > ramp.front().x();
    std::vector<Eigen::Vector3d> route = {(ground[0] + ground[1]) / 2};
    for (const std::size_t i : {std::size_t{1}, std::size_t{2}, std::size_t{3}, std::size_t{0}})
        route.push_back(ground[i]);
    // On from the south-western corner, around once more up to the ramp.
    if (east) {
        route.push_back(ground[0] + 0.5 * (ground[1] - ground[0]));
        route.push_back(ground[1]);
        route.push_back(ground[2]);
    } else {
        route.push_back(ground[1]);
        route.push_back(ground[2]);
    }
    route.insert(route.end(), ramp.begin(), ramp.end());
    // Out of the ramp's upper end to the left, and around the upper ring to where it began.
    for (const std::size_t i : {std::size_t{3}, std::size_t{0}, std::size_t{1}, std::size_t{2}})
        route.push_back(above[i]);
    route.push_back(ramp.back() + Eigen::Vector3d(east ? -8.0 : 8.0, 0.0, 0.0));
    return route;
}

void print(const char* how, const BuildingResult& result) {
    std::printf("    %-6s %7.3f %7.3f %7.3f %7.3f %7.2f\n", how, result.ate, result.seam, result.surfaces,
                result.height, inDegrees(result.angle));
}

BuildingRow driven(const Building& building, const std::vector<Eigen::Vector3d>& corners,
                   const ScriptSettings& script, const LiveSettings& mapping) {
    const auto begin = std::chrono::steady_clock::now();
    ScriptedDrive made = scriptedDrive(building.arena, DrivePath(corners), script);
    const double casting = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const auto corrected = [&](const ScannerCorrection& correction) {
        ScriptSettings better = script;
        better.correction = correction;
        return scriptedDrive(building.arena, DrivePath(corners), better).scans;
    };
    const MappedDrive result = mapped(made.drive, std::move(made.scans), mapping, corrected);
    BuildingRow row = rowOf(building, made.drive, result);
    row.casting = casting;
    return row;
}

BuildingRow driven(const Building& building, const std::vector<Eigen::Vector3d>& corners,
                   const ScriptSettings& script, const PlaneLaserSettings& laser,
                   const LiveSettings& mapping) {
    ScriptedDrive made = scriptedDrive(building.arena, DrivePath(corners), script, laser);
    return rowOf(building, made.drive, mapped(made.drive, std::move(made.scans), mapping));
}

BuildingRow rowOf(const Building& building, const RecordedDrive& drive, const MappedDrive& result) {
    BuildingRow row;
    row.scans = result.scans.size();
    row.keyScans = result.map->scans.size();
    row.way = drive.way;
    row.odometry = errorOf(result.odometry).distance;
    for (const Localisation& one : result.localisations)
        row.uncertain += one.trust != ScanTrust::Certain ? 1 : 0;
    row.median = quantile(result.busy, 0.5);
    row.longest = quantile(result.busy, 1.0);
    row.early = busyAbout(100, result);
    row.late = busyAbout(1'000, result);
    row.beside = besideOf(result);
    row.solves = result.solving.size();
    row.contradicted = result.contradicted;
    row.correction = result.correction;
    row.corrections = result.corrections;
    if (row.solves > 0) {
        row.solving = quantile(result.solving, 1.0);
        row.settling = quantile(result.settling, 1.0);
    }
    const NearSurfaces surfaces(building.arena);
    const TrajectoryError entry = errorOf(result.live);
    row.entry = {entry.distance, entry.height, entry.angle, worstSeam(result.live),
                 surfaceErrorOf(*result.map, surfaces, entry.mapInArena, entryOfKeys(result))};
    const Trajectory last = finalPoses(result, drive, false);
    const TrajectoryError final = errorOf(last);
    row.final = {final.distance, final.height, final.angle, worstSeam(finalPoses(result, drive, true)),
                 surfaceErrorOf(*result.map, surfaces, final.mapInArena, last.found)};
    row.finds = findErrors(building.arena, last, final.mapInArena);
    return row;
}

}  // namespace leitstand::simulation::test
