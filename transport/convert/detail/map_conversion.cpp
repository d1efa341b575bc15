#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/event/all_samples.h"
#include "messages/leitstand_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

using wire::geometry_msgs::Point;
constexpr int MostRows = 65'536;            // rows and columns of any scanner
constexpr std::size_t MostCorners = 1'000;  // of the area that a map is cropped to
constexpr std::size_t MostBodies = 4'000;   // of other robots in all scans of a message
constexpr std::size_t MostBodyCorners = 64;
constexpr double LargestBody = 10.0, LargestMargin = 1.0;  // [m]

/// Checks that the lists of a scan fit its points and its grid.
void checkScan(const Scan& scan, Checks& checks) {
    const std::size_t count = scan.points.size();
    const std::size_t grid = static_cast<std::size_t>(scan.rows) * static_cast<std::size_t>(scan.columns);
    checks.require((scan.rows == 0 && scan.columns == 0) || grid == count, "rows, columns",
                   "{} x {} does not fit {} points", scan.rows, scan.columns, count);
    checks.require(scan.intensities.empty() || scan.intensities.size() == count, "intensities",
                   "expected {} or none, found {}", count, scan.intensities.size());
    checks.require(scan.labels.empty() || scan.labels.size() == count, "labels",
                   "expected {} or none, found {}", count, scan.labels.size());
}

std::vector<Label> labels(std::span<const std::byte> from, Checks& checks) {
    std::vector<Label> to(from.size());
    for (std::size_t i = 0; i < from.size(); ++i) {
        to[i] = checks.enumerator<Label>("labels", std::to_integer<unsigned>(from[i]), LabelCount);
    }
    return to;
}

}  // namespace

KeyScanSample fromWire(const wire::leitstand_msgs::KeyScan& from, const Source&, Checks& checks) {
    auto scan = std::make_shared<Scan>();
    scan->name = from.name;
    scan->robot = from.robot;
    scan->start = checks.time("start", from.start);
    scan->end = checks.time("end", from.end);
    scan->hasOdometry = from.has_odometry;
    scan->sensorInOdom = checks.pose("sensor_in_odom", from.sensor_in_odom);
    scan->rows = checks.size("rows", from.rows, MostRows);
    scan->columns = checks.size("columns", from.columns, MostRows);
    scan->sweep = checks.enumerator<Sweep>("sweep", from.sweep, 2);
    checks.require(from.points.size() % 3 == 0, "points", "expected three numbers a point, found {} numbers",
                   from.points.size());
    scan->points.resize(from.points.size() / 3);
    for (std::size_t i = 0; i < scan->points.size(); ++i) {
        scan->points[i] = {from.points[3 * i], from.points[3 * i + 1], from.points[3 * i + 2]};
    }
    scan->intensities = from.intensities;
    scan->labels = labels(from.labels, checks);
    checkScan(*scan, checks);
    KeyScanSample to;
    to.stamp = checks.time("stamp", from.stamp);
    to.id = from.id;
    checks.require(from.id > 0, "id", "expected a number from 1");
    to.sensorInBase = checks.pose("sensor_in_base", from.sensor_in_base);
    to.scanInMap = checks.pose("scan_in_map", from.scan_in_map);
    to.matched = from.matched;
    to.scan = std::move(scan);
    return to;
}

void toWire(const KeyScanSample& from, wire::leitstand_msgs::KeyScan& to, Buffer&, Checks& checks) {
    checks.require(from.scan != nullptr, "scan", "expected one");
    if (!checks.ok()) return;
    const Scan& scan = *from.scan;
    checkScan(scan, checks);
    to.stamp = checks.wireTime("stamp", from.stamp);
    to.id = from.id;
    to.name = scan.name;
    to.robot = scan.robot;
    to.start = checks.wireTime("start", scan.start);
    to.end = checks.wireTime("end", scan.end);
    to.has_odometry = scan.hasOdometry;
    to.sensor_in_odom = checks.wirePose("sensor_in_odom", scan.sensorInOdom);
    to.sensor_in_base = checks.wirePose("sensor_in_base", from.sensorInBase);
    to.scan_in_map = checks.wirePose("scan_in_map", from.scanInMap);
    to.matched = from.matched;
    to.rows = checks.wireSize("rows", scan.rows);
    to.columns = checks.wireSize("columns", scan.columns);
    to.sweep = static_cast<std::uint8_t>(scan.sweep);
    to.points.reserve(3 * scan.points.size());
    for (const Eigen::Vector3f& point : scan.points) {
        to.points.insert(to.points.end(), {point.x(), point.y(), point.z()});
    }
    to.intensities = scan.intensities;
    to.labels = std::as_bytes(std::span(scan.labels));
}

ScanPosesSample fromWire(const wire::leitstand_msgs::ScanPoses& from, const Source&, Checks& checks) {
    ScanPosesSample to;
    to.stamp = checks.time("stamp", from.stamp);
    to.station = from.station;
    to.cause = checks.enumerator<ScanPosesSample::Cause>("cause", from.cause, 3);
    to.poses.reserve(from.poses.size());
    for (const auto& one : from.poses) {
        checks.require(one.scan > 0, "poses.scan", "expected a number from 1");
        to.poses.push_back(
            {one.scan, checks.pose("poses.scan_in_map", one.scan_in_map), checks.known("poses.rms", one.rms),
             checks.known("poses.inlier_ratio", one.inlier_ratio), checks.known("poses.overlap", one.overlap),
             checks.known("poses.certainty", one.certainty), one.converged,
             checks.enumerator<ScanTrust>("poses.trust", one.trust, 3), one.doubts});
    }
    return to;
}

void toWire(const ScanPosesSample& from, wire::leitstand_msgs::ScanPoses& to, Buffer&, Checks& checks) {
    to.stamp = checks.wireTime("stamp", from.stamp);
    to.station = from.station;
    to.cause = static_cast<std::uint8_t>(from.cause);
    for (const ScanPose& one : from.poses) {
        to.poses.push_back({one.scan, checks.wirePose("poses.scan_in_map", one.scanInMap), one.rms,
                            one.inlierRatio, one.overlap, one.certainty, one.converged,
                            static_cast<std::uint8_t>(one.trust), one.doubts});
    }
}

namespace {

constexpr std::size_t MostLinks = 10'000;  // in one message
constexpr double MostInformation = 1e12;   // for a deviation of a micrometre

/// Returns whether @p information, symmetric already, is bounded and positive semidefinite.
bool isInformation(const Information& information) {
    if (!information.allFinite() || information.cwiseAbs().maxCoeff() > MostInformation) return false;
    const double most = std::max(1.0, information.diagonal().maxCoeff());
    const Eigen::SelfAdjointEigenSolver<Information> solver(information, Eigen::EigenvaluesOnly);
    return solver.eigenvalues().minCoeff() >= -1e-9 * most;
}

void checkLinks(std::size_t links, Checks& checks) {
    checks.require(links <= MostLinks, "links", "expected at most {}, found {}", MostLinks, links);
}

}  // namespace

ScanLinksSample fromWire(const wire::leitstand_msgs::ScanLinks& from, const Source&, Checks& checks) {
    checkLinks(from.links.size(), checks);
    ScanLinksSample to;
    to.stamp = checks.time("stamp", from.stamp);
    to.station = from.station;
    if (!checks.ok()) return to;
    to.links.reserve(from.links.size());
    for (const auto& one : from.links) {
        checks.require(one.id > 0, "links.id", "expected a number from 1");
        checks.require(one.from_scan > 0 && one.to_scan > 0, "links", "expected scans of a number from 1");
        Link link;
        link.id = one.id;
        link.from = one.from_scan;
        link.to = one.to_scan;
        link.pose = checks.pose("links.to_in_from", one.to_in_from);
        link.kind = checks.enumerator<LinkKind>("links.kind", one.kind, LinkKindCount);
        link.station = from.station;
        link.active = one.active;
        std::size_t next = 0;
        for (Eigen::Index row = 0; row < 6; ++row) {
            for (Eigen::Index column = row; column < 6; ++column)
                link.information(row, column) = link.information(column, row) = one.information[next++];
        }
        checks.require(isInformation(link.information), "links.information",
                       "expected an inverse covariance: numbers up to {}, no direction below 0",
                       MostInformation);
        if (!checks.ok()) return to;
        to.links.push_back(std::move(link));
    }
    return to;
}

void toWire(const ScanLinksSample& from, wire::leitstand_msgs::ScanLinks& to, Buffer&, Checks& checks) {
    checkLinks(from.links.size(), checks);
    to.stamp = checks.wireTime("stamp", from.stamp);
    to.station = from.station;
    for (const Link& link : from.links) {
        checks.require(isInformation(link.information), "links.information",
                       "expected an inverse covariance");
        wire::leitstand_msgs::ScanLink one;
        one.id = link.id;
        one.from_scan = link.from;
        one.to_scan = link.to;
        one.to_in_from = checks.wirePose("links.to_in_from", link.pose);
        one.kind = static_cast<std::uint8_t>(link.kind);
        one.active = link.active;
        std::size_t next = 0;
        for (Eigen::Index row = 0; row < 6; ++row) {
            for (Eigen::Index column = row; column < 6; ++column)
                one.information[next++] = link.information(row, column);
        }
        to.links.push_back(one);
    }
}

namespace {

template <class Scans>
void checkBodies(const Scans& scans, Checks& checks) {
    std::size_t bodies = 0;
    for (const auto& one : scans) {
        checks.require(one.scan > 0, "scans.scan", "expected a number from 1");
        bodies += one.bodies.size();
    }
    checks.require(scans.size() <= MostBodies, "scans", "expected at most {}, found {}", MostBodies,
                   scans.size());
    checks.require(bodies <= MostBodies, "scans.bodies", "expected at most {}, found {}", MostBodies, bodies);
}

void checkBody(const BodyInScan& body, Checks& checks) {
    const std::size_t corners = body.footprint.size();
    const bool inside = std::all_of(body.footprint.begin(), body.footprint.end(), [](const auto& corner) {
        return corner.cwiseAbs().maxCoeff() <= LargestBody;
    });
    checks.require(corners >= 3 && corners <= MostBodyCorners && inside, "scans.bodies.footprint",
                   "expected 3 to {} corners within {} m, found {}", MostBodyCorners, LargestBody, corners);
    checks.require(body.height >= 0.0 && body.height <= LargestBody, "scans.bodies.height",
                   "expected 0 to {} m", LargestBody);
    checks.require(body.margin >= 0.0 && body.margin <= LargestMargin, "scans.bodies.margin",
                   "expected 0 to {} m", LargestMargin);
}

BodyInScan bodyFrom(const wire::leitstand_msgs::BodyInScan& from, Checks& checks) {
    BodyInScan body{from.robot,
                    {},
                    from.height,
                    checks.pose("scans.bodies.base_in_scan", from.base_in_scan),
                    from.margin};
    for (const Point& corner : from.footprint)
        body.footprint.emplace_back(checks.vector("scans.bodies.footprint", corner).head<2>());
    checkBody(body, checks);
    return body;
}

wire::leitstand_msgs::BodyInScan wireBody(const BodyInScan& body, Checks& checks) {
    checkBody(body, checks);
    wire::leitstand_msgs::BodyInScan to;
    to.robot = body.robot;
    for (const Eigen::Vector2d& corner : body.footprint)
        to.footprint.push_back(
            checks.wireVector<Point>("scans.bodies.footprint", {corner.x(), corner.y(), 0.0}));
    to.height = body.height;
    to.base_in_scan = checks.wirePose("scans.bodies.base_in_scan", body.baseInScan);
    to.margin = body.margin;
    return to;
}

}  // namespace

ScanBodiesSample fromWire(const wire::leitstand_msgs::ScanBodies& from, const Source&, Checks& checks) {
    checkBodies(from.scans, checks);
    ScanBodiesSample to{checks.time("stamp", from.stamp), from.station, {}};
    for (const auto& one : from.scans) {
        if (!checks.ok()) return to;
        BodiesOfScan& scan = to.scans.emplace_back();
        scan.scan = one.scan;
        for (const auto& body : one.bodies) {
            scan.bodies.push_back(bodyFrom(body, checks));
            if (!checks.ok()) return to;
        }
    }
    return to;
}

void toWire(const ScanBodiesSample& from, wire::leitstand_msgs::ScanBodies& to, Buffer&, Checks& checks) {
    checkBodies(from.scans, checks);
    to.stamp = checks.wireTime("stamp", from.stamp);
    to.station = from.station;
    for (const BodiesOfScan& one : from.scans) {
        wire::leitstand_msgs::BodiesOfScan& scan = to.scans.emplace_back();
        scan.scan = one.scan;
        for (const BodyInScan& body : one.bodies) scan.bodies.push_back(wireBody(body, checks));
    }
}

namespace {

void checkCorners(std::size_t corners, Checks& checks) {
    checks.require(corners == 0 || (corners >= 3 && corners <= MostCorners), "polygon",
                   "expected none, or 3 to {} corners, found {}", MostCorners, corners);
}

}  // namespace

MapCropSample fromWire(const wire::leitstand_msgs::MapCrop& from, const Source&, Checks& checks) {
    checkCorners(from.polygon.size(), checks);
    MapCropSample to;
    to.stamp = checks.time("stamp", from.stamp);
    to.station = from.station;
    if (!checks.ok()) return to;
    for (const Point& corner : from.polygon)
        to.polygon.emplace_back(checks.vector("polygon", corner).head<2>());
    if (!std::isnan(from.ceiling)) to.ceiling = checks.finite("ceiling", from.ceiling);
    return to;
}

void toWire(const MapCropSample& from, wire::leitstand_msgs::MapCrop& to, Buffer&, Checks& checks) {
    checkCorners(from.polygon.size(), checks);
    to.stamp = checks.wireTime("stamp", from.stamp);
    to.station = from.station;
    for (const Eigen::Vector2d& corner : from.polygon)
        to.polygon.push_back(checks.wireVector<Point>("polygon", {corner.x(), corner.y(), 0.0}));
    to.ceiling = std::isinf(from.ceiling) ? std::numeric_limits<double>::quiet_NaN()
                                          : checks.finite("ceiling", from.ceiling);
}

RobotPlaceSample fromWire(const wire::leitstand_msgs::RobotPlace& from, const Source&, Checks& checks) {
    checks.require(!from.robot.empty(), "robot", "expected a name");
    return {checks.time("stamp", from.stamp),
            from.station,
            from.robot,
            checks.enumerator<RobotPlaceSample::Cause>("cause", from.cause, 5),
            checks.time("measured", from.measured),
            checks.pose("base_in_map", from.base_in_map),
            checks.pose("odom_in_map", from.odom_in_map),
            checks.known("certainty", from.certainty),
            checks.known("overlap", from.overlap),
            from.certain,
            from.how};
}

void toWire(const RobotPlaceSample& from, wire::leitstand_msgs::RobotPlace& to, Buffer&, Checks& checks) {
    to = {checks.wireTime("stamp", from.stamp),
          from.station,
          from.robot,
          static_cast<std::uint8_t>(from.cause),
          checks.wireTime("measured", from.measured),
          checks.wirePose("base_in_map", from.baseInMap),
          checks.wirePose("odom_in_map", from.odomInMap),
          from.certainty,
          from.overlap,
          from.certain,
          from.how};
}

std::vector<Conversion> mapConversions() {
    return {
        stationConversion<wire::leitstand_msgs::KeyScan, KeyScanSample>(),
        stationConversion<wire::leitstand_msgs::ScanPoses, ScanPosesSample>(),
        stationConversion<wire::leitstand_msgs::ScanLinks, ScanLinksSample>(),
        stationConversion<wire::leitstand_msgs::ScanBodies, ScanBodiesSample>(),
        stationConversion<wire::leitstand_msgs::MapCrop, MapCropSample>(),
        stationConversion<wire::leitstand_msgs::RobotPlace, RobotPlaceSample>(),
    };
}

}  // namespace leitstand::detail
