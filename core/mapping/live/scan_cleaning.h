#pragma once

#include <limits>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/event/scan_bodies.h"

namespace leitstand {

/// The space that a robot takes up, base frame.
struct RobotBody {
    std::vector<Eigen::Vector2d> footprint;  ///< counter-clockwise [m]
    double height = 0.0;                     ///< [m]
};

/// Another robot in the map.
struct PlacedBody {
    static constexpr double Certain = 0.1;  ///< margin of a robot whose place is certain [m]

    RobotBody body;
    Pose baseInMap = Pose::Identity();
    double margin = Certain;  ///< it may be so far from `baseInMap` [m]; above Certain: its pose is doubted
};

/// Returns the bodies of a scan in the map, for the scan at @p scanInMap.
[[nodiscard]] std::vector<PlacedBody> placed(std::span<const BodyInScan> bodies, const Pose& scanInMap);
/// Returns @p bodies, all of @p robot, relative to a scan at @p scanInMap.
[[nodiscard]] std::vector<BodyInScan> inScan(const std::string& robot, std::span<const PlacedBody> bodies,
                                             const Pose& scanInMap);

/// The part of the world that belongs to the map: spectators stand around it.
struct MapCrop {
    std::vector<Eigen::Vector2d> polygon;                      ///< map frame [m]; empty: everything
    double ceiling = std::numeric_limits<double>::infinity();  ///< higher points are left out, map frame [m]

    [[nodiscard]] bool contains(const Eigen::Vector3d& pointInMap) const;
    [[nodiscard]] bool open() const { return polygon.empty() && !(ceiling < 1e9); }
};

/// Returns whether @p place (base frame, seen from above) is on or within @p body's footprint, grown by @p
/// margin [m].
[[nodiscard]] bool onFootprint(const RobotBody& body, const Eigen::Vector2d& place, double margin);
/// Turns points of @p scan on or within @p body, grown by @p margin [m], into no echo. Points of the ground
/// below the robot stay.
void leaveOutBody(Scan& scan, const RobotBody& body, const Pose& sensorInBase, double margin = 0.05);
/// Returns for each of @p points, in a scan at @p scanInMap, whether it is on or within one of @p others.
/// Points of a thing that continues above the robot's height, as a wall or a post, do not count. On the
/// footprint of a robot whose pose is certain, they do.
[[nodiscard]] std::vector<bool> onOthers(std::span<const Eigen::Vector3f> points,
                                         std::span<const PlacedBody> others, const Pose& scanInMap);
/// Turns points of @p scan at @p scanInMap that are onOthers() into no echo.
void leaveOutBodies(Scan& scan, std::span<const PlacedBody> others, const Pose& scanInMap);
/// Turns points of @p scan, at @p scanInMap, outside @p crop into no echo.
void leaveOutCropped(Scan& scan, const MapCrop& crop, const Pose& scanInMap);

}  // namespace leitstand
