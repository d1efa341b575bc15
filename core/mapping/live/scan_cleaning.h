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

/// The space that a robot takes up, in the frame of its base.
struct RobotBody {
    std::vector<Eigen::Vector2d> footprint;  ///< outline, counter-clockwise [m]
    double height = 0.0;                     ///< [m]
};

/// Another robot in the map.
struct PlacedBody {
    static constexpr double Certain = 0.1;  ///< margin of a robot whose place is certain [m]

    RobotBody body;
    Pose baseInMap = Pose::Identity();
    /// Largest error of `baseInMap` [m]; above Certain: the robot's pose is in doubt.
    double margin = Certain;
};

/// Returns @p bodies, which are relative to a scan, in the map. @p scanInMap: pose of the scan.
[[nodiscard]] std::vector<PlacedBody> placed(std::span<const BodyInScan> bodies, const Pose& scanInMap);
/// Returns @p bodies, which all belong to @p robot, relative to a scan at @p scanInMap.
[[nodiscard]] std::vector<BodyInScan> inScan(const std::string& robot, std::span<const PlacedBody> bodies,
                                             const Pose& scanInMap);

/// The area that belongs to the map. Spectators may stand around it.
struct MapCrop {
    std::vector<Eigen::Vector2d> polygon;  ///< outline in the map [m]; empty: the whole world
    /// Higher points are left out, height in the map [m].
    double ceiling = std::numeric_limits<double>::infinity();

    [[nodiscard]] bool contains(const Eigen::Vector3d& pointInMap) const;
    [[nodiscard]] bool open() const { return polygon.empty() && !(ceiling < 1e9); }
};

/// Returns whether @p place (base frame, seen from above) is on or within the footprint of @p body plus
/// @p margin [m].
[[nodiscard]] bool onFootprint(const RobotBody& body, const Eigen::Vector2d& place, double margin);
/// Removes points on or within @p body plus @p margin [m] from @p scan: they become "no echo". Points of the
/// ground below the robot stay.
void leaveOutBody(Scan& scan, const RobotBody& body, const Pose& sensorInBase, double margin = 0.05);
/// Returns for each of @p points, in a scan at @p scanInMap, whether it is on or within one of @p others.
/// Points of a thing that continues above the robot's height, such as a wall or a post, are not on the robot.
/// If the robot's pose is certain, all points on its footprint are.
[[nodiscard]] std::vector<bool> onOthers(std::span<const Eigen::Vector3f> points,
                                         std::span<const PlacedBody> others, const Pose& scanInMap);
/// Removes points that are onOthers() from @p scan, which is at @p scanInMap: they become "no echo".
void leaveOutBodies(Scan& scan, std::span<const PlacedBody> others, const Pose& scanInMap);
/// Removes points outside @p crop from @p scan, which is at @p scanInMap: they become "no echo".
void leaveOutCropped(Scan& scan, const MapCrop& crop, const Pose& scanInMap);

}  // namespace leitstand
