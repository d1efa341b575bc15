#include "core/mapping/live/scan_work.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/cloud/filters/cell_table.h"
#include "core/cloud/filters/grid_tangents.h"
#include "core/cloud/filters/normals.h"
#include "core/cloud/filters/outliers.h"
#include "core/cloud/filters/range_filter.h"
#include "core/cloud/filters/voxel_grid.h"
#include "core/cloud/labels.h"
#include "core/cloud/shades.h"
#include "core/event/scan_pose.h"
#include "core/mapping/plane/plane_scan.h"

namespace leitstand {

namespace {

constexpr double Finer = 0.5;     ///< of the grid for matching
constexpr std::size_t Few = 400;  ///< points; a scan with fewer is matched on the finer grid

/// Returns all of @p scan but its points, and how they lay in the scanner's grid.
Scan headOf(const Scan& scan) {
    Scan head;
    head.name = scan.name;
    head.robot = scan.robot;
    head.start = scan.start;
    head.end = scan.end;
    head.sensorInOdom = scan.sensorInOdom;
    head.hasOdometry = scan.hasOdometry;
    head.sweep = scan.sweep;
    return head;
}

/// Returns the first point of each cube of edge @p edge [m] among those of @p scan in range, with all its
/// values.
Scan thinned(const Scan& scan, const MatchSettings& settings, double edge) {
    std::vector<std::size_t> kept;
    detail::CellTable cells(edge, scan.points.size() / 2);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const double range = scan.points[i].cast<double>().norm();
        if (!(range >= settings.minRange && range <= settings.maxRange)) continue;
        if (cells.cellOf(scan.points[i]) == kept.size()) kept.push_back(i);
    }
    return selected(scan, kept);
}

/// Returns @p cloud without labels, which are not used, on a grid of @p edge [m] with an origin of its own.
PointCloud onOwnGrid(PointCloud cloud, double edge) {
    cloud.labels.clear();
    return voxelGrid(cloud, edge, VoxelPoint::Centroid, ownGridOrigin(cloud.points, edge));
}

/// Returns the cloud for matching of @p cloud. Close to a wall little is seen, so the grid is finer.
PointCloud onMatchGrid(const PointCloud& cloud, double edge) {
    PointCloud reduced = onOwnGrid(cloud, edge);
    return reduced.size() < Few ? onOwnGrid(cloud, Finer * edge) : reduced;
}

/// Returns the cloud for matching of the plane laser's @p scan. Its squares are smaller than the cubes of
/// other scans, since it has few points.
PointCloud planeForMatching(const Scan& scan, const MatchSettings& settings) {
    return wallsAndFloor(pointsInRange(scan, {}, settings.minRange, settings.maxRange).points,
                         Finer * settings.reduce);
}

/// Turns @p normals of the organised @p scan towards where each point was seen from. Its rows follow each
/// other in time, and its sensor came in a straight line from @p began. A robot that drove through a door
/// within the turn saw the wall around it from both sides.
void faceSensor(std::vector<Eigen::Vector3f>& normals, const Scan& scan, const Eigen::Vector3d& began) {
    const auto columns = static_cast<std::size_t>(scan.columns);
    const auto last = static_cast<double>(std::max(1, scan.rows - 1));
    for (std::size_t i = 0; i < normals.size(); ++i) {
        const double left = 1.0 - static_cast<double>(i / columns) / last;
        const Eigen::Vector3f sensor = (left * began).cast<float>();
        if (normals[i].dot(scan.points[i] - sensor) > 0.0F) normals[i] = -normals[i];
    }
}

/// Labels @p scan, which @p live holds. Returns its normals if it is organised.
std::vector<Eigen::Vector3f> label(Scan& scan, const LiveScan& live) {
    LabelSettings labels;
    labels.up = live.up;
    if (!scan.organised()) {
        scan.labels = labelScan(scan, labels);
        return {};
    }
    const GridTangents tangents = gridTangents(scan);
    std::vector<Eigen::Vector3f> normals = gridNormals(scan, tangents);
    scan.labels = labelScan(scan, tangents, normals, labels);
    if (live.end != TurnEnd::Sweep) faceSensor(normals, scan, live.began);
    return normals;
}

/// Returns the prior by odometry after @p step, for the match.
GuessPrior priorOf(const Step& step, const MatchSettings& settings) {
    GuessPrior prior;
    prior.openBelow = settings.openBelow;
    prior.deviation = settings.odometry.deviation(step.way, step.turn);
    return prior;
}

/// Returns whether a scan fits at @p found instead of @p guess because wheels spun. Then it is on odometry's
/// path, less far along, and not far aside.
bool isShortOf(const Eigen::Vector3d& found, const Eigen::Vector3d& guess, const Step& step,
               const FitSettings& fit) {
    const double reported = step.moved.norm();
    if (reported <= 0.0) return false;
    const Eigen::Vector3d ahead = step.moved / reported, came = found - (guess - step.moved);
    const double along = ahead.dot(came), aside = (came - along * ahead).norm();
    return along >= -fit.jump && along <= reported && aside <= fit.spunAside + fit.spunAsideOfWay * reported;
}

}  // namespace

Scan cleaned(const LiveScan& live, const RobotBody& body, const Pose& scanInMap, const LiveSettings& settings,
             std::span<const PlacedBody> others) {
    Scan scan = *live.scan;
    leaveOutBody(scan, body, live.sensorInBase);
    leaveOutBodies(scan, others, scanInMap);
    leaveOutCropped(scan, settings.crop, scanInMap);
    return scan;
}

ReadyScan readyScan(const LiveScan& live, const RobotBody& body, const Pose& scanInMap,
                    const LiveSettings& settings, std::span<const PlacedBody> others) {
    const MatchSettings& match = settings.match;
    Scan scan = withoutMixedPixels(cleaned(live, body, scanInMap, settings, others));
    const std::vector<Eigen::Vector3f> normals = label(scan, live);
    ReadyScan ready;
    if (live.plane) {
        ready.reduced = planeForMatching(scan, match);
    } else {
        ready.reduced =
            onMatchGrid(pointsInRange(scan, normals, match.minRange, match.maxRange), match.reduce);
        if (ready.reduced.normals.empty()) ready.reduced.normals = knnNormals(ready.reduced.points);
    }
    ready.scan = std::make_shared<const Scan>(thinned(scan, match, settings.kept));
    return ready;
}

Scan selected(const Scan& scan, const std::vector<std::size_t>& kept) {
    Scan result = headOf(scan);
    const bool intensities = scan.intensities.size() == scan.points.size();
    const bool labels = scan.labels.size() == scan.points.size();
    const bool shades = scan.shades.size() == scan.points.size();
    result.points.reserve(kept.size());  // an hour has hundreds of scans, so none has spare room
    if (labels) result.labels.reserve(kept.size());
    if (intensities) result.intensities.reserve(kept.size());
    if (shades) result.shades.reserve(kept.size());
    for (const std::size_t i : kept) {
        result.points.push_back(scan.points[i]);
        if (labels) result.labels.push_back(scan.labels[i]);
        if (intensities) result.intensities.push_back(scan.intensities[i]);
        if (shades) result.shades.push_back(scan.shades[i]);
    }
    return result;
}

ScanPtr keptOf(const ScanPtr& scan) {
    if (scan->intensities.empty()) return scan;
    auto kept = std::make_shared<Scan>(headOf(*scan));
    kept->rows = scan->rows;
    kept->columns = scan->columns;
    kept->points = scan->points;
    kept->labels = scan->labels;
    kept->shades = scan->intensities.size() == scan->points.size() ? shadesOf(scan->intensities)
                                                                   : std::vector<std::uint8_t>();
    return kept;
}

std::size_t memoryOf(const LiveKeyScan& scan) {
    const auto bytes = [](const auto& list) { return list.capacity() * sizeof(list.front()); };
    std::size_t sum = sizeof(LiveKeyScan);
    if (scan.scan)
        sum += bytes(scan.scan->points) + bytes(scan.scan->intensities) + bytes(scan.scan->labels) +
               bytes(scan.scan->shades);
    if (scan.reduced) sum += scan.reduced->memory();
    return sum;
}

PointCloud reducedAgain(const Scan& scan, const MatchSettings& settings) {
    if (isPlaneScan(scan.points)) return planeForMatching(scan, settings);
    // Normals of all points would take many times as long.
    PointCloud all =
        onOwnGrid(pointsInRange(scan, {}, settings.minRange, settings.maxRange), Finer * settings.reduce);
    all.normals = knnNormals(all.points, 12);
    return onMatchGrid(all, settings.reduce);
}

bool canBegin(const LiveScan& live, const PointCloud& reduced, const FitSettings& fit) {
    if (static_cast<int>(reduced.size()) < fit.leastPoints) return false;
    if (live.end == TurnEnd::Turn || live.end == TurnEnd::Sweep) return true;
    std::bitset<36> seen;  // directions
    for (const Eigen::Vector3f& point : live.scan->points) {
        if (!point.allFinite()) continue;
        const double turns = std::atan2(point.y(), point.x()) / (2.0 * std::numbers::pi) + 0.5;
        seen.set(std::min(static_cast<std::size_t>(turns * double(seen.size())), seen.size() - 1));
    }
    return degrees(360) * double(seen.count()) / double(seen.size()) >= fit.leastSeen;
}

Pose levelled(const Pose& scanInMap, const Eigen::Vector3d& up, double share) {
    const Eigen::Vector3d upInMap = scanInMap.linear() * up;
    const auto full = Eigen::Quaterniond::FromTwoVectors(upInMap, Eigen::Vector3d::UnitZ());
    Pose result = scanInMap;
    result.linear() =
        (Eigen::Quaterniond::Identity().slerp(share, full) * Eigen::Quaterniond(scanInMap.linear()))
            .normalized()
            .toRotationMatrix();
    return result;
}

double newGround(const PointCloud& cloud, const LocalMap& local, const Pose& scanInMap, double distance) {
    if (cloud.points.empty()) return 0.0;
    if (!local.search) return 1.0;
    const Eigen::Isometry3f motion = scanInMap.cast<float>();
    const auto bound = static_cast<float>(distance * distance);
    const auto fresh =
        std::count_if(cloud.points.begin(), cloud.points.end(), [&](const Eigen::Vector3f& point) {
            return !local.search->nearest(motion * point, Label::Unlabelled, bound).found();
        });
    return static_cast<double>(fresh) / static_cast<double>(cloud.size());
}

Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
            const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings, const FitSettings& fit) {
    using Schedules = std::vector<const std::vector<double>*>;
    const Schedules schedules = step.trusted ? Schedules{&settings.near, &settings.tight, &settings.wide}
                                             : Schedules{&settings.wide, &settings.near, &settings.tight};
    Match first;
    std::optional<Match> spun;
    for (const std::vector<double>* schedule : schedules) {
        Match one = match(cloud, local, guess, step, up, settings, fit, *schedule);
        if (schedule == schedules.front()) first = one;
        // One that fits worse has only missed what the first one found.
        if (one.doubts != 0 || one.icp.overlap < first.icp.overlap) continue;
        if (!one.spun) return one;
        if (!spun) spun = one;  // unless one fits at odometry's pose
    }
    return spun.value_or(first);
}

Match match(const PointCloud& cloud, const LocalMap& local, const Pose& guess, const Step& step,
            const std::optional<Eigen::Vector3d>& up, const MatchSettings& settings, const FitSettings& fit,
            const std::vector<double>& schedule) {
    Match result;
    result.scanInMap = guess;
    const auto doubtIf = [&](bool wrong, ScanDoubt doubt) {
        if (wrong) result.doubts |= static_cast<std::uint8_t>(doubt);
    };
    doubtIf(static_cast<int>(cloud.size()) < fit.leastPoints, ScanDoubt::Points);
    doubtIf(!local.search, ScanDoubt::Overlap);
    if (result.doubts != 0) return result;
    IcpSettings icp;
    icp.maxDistances = schedule;
    icp.judgedWithin = settings.judgedWithin;
    icp.maxIterations = settings.maxIterations;
    icp.threads = 1;
    icp.facing = true;
    icp.minStep = 5e-4;
    if (step.measured) icp.prior = priorOf(step, settings);
    result.icp = align(local.cloud, *local.search, cloud, guess, icp);
    const IcpResult& found = result.icp;
    const bool open = found.stop == IcpStop::Degenerate;
    // Odometry holds open directions for a while.
    const bool held = !open && step.measured && found.open > 0 &&
                      settings.odometry.share * std::min(step.openWay, fit.openWay) <= fit.mostDeviation;
    doubtIf(!open && !found.converged, ScanDoubt::Diverged);
    doubtIf(found.overlap < (step.measured ? fit.leastOverlap : fit.leastOverlapUnguided),
            ScanDoubt::Overlap);
    doubtIf(!step.measured && has(result.doubts, ScanDoubt::Overlap), ScanDoubt::Odometry);
    doubtIf(found.rms > fit.mostResidual, ScanDoubt::Residual);
    doubtIf(open || (!held && found.certainty < fit.leastCertainty), ScanDoubt::Certainty);
    const double jump = distanceBetween(guess, found.pose), turn = angleBetween(guess, found.pose);
    const bool turned = turn > fit.turn + fit.turnOfTurn * step.turn + fit.turnOfWay * step.way;
    const bool jumped = jump > fit.jump + fit.jumpOfWay * step.way;
    // A robot that a wall holds continues to drive by its odometry.
    result.spun = jumped && !turned && result.doubts == 0 && found.open == 0 &&
                  found.certainty >= settings.openBelow && found.overlap >= fit.spunOverlap &&
                  isShortOf(found.pose.translation(), guess.translation(), step, fit);
    doubtIf(step.measured && !result.spun && (jumped || turned), ScanDoubt::Jump);
    if (result.doubts != 0) return result;
    result.scanInMap = up ? levelled(found.pose, *up, settings.levelShare) : found.pose;
    return result;
}

Eigen::Vector3d upOf(const LiveKeyScan& scan) {
    return scan.up.value_or(scan.pose.scanInMap.linear().transpose() * Eigen::Vector3d::UnitZ());
}

}  // namespace leitstand
