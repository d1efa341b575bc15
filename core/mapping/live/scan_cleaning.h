#pragma once

#include <limits>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/scan/scan.h"

namespace leitstand {

/// What a robot takes up, base frame.
struct RobotBody {
    std::vector<Eigen::Vector2d> footprint;  ///< counter-clockwise [m]
    double height = 0.0;                     ///< [m]
};

/// What of the world belongs into the map: spectators stand around it.
struct MapCrop {
    std::vector<Eigen::Vector2d> polygon;                      ///< map frame [m]; empty: everything
    double ceiling = std::numeric_limits<double>::infinity();  ///< what is higher is left out, map frame [m]

    [[nodiscard]] bool contains(const Eigen::Vector3d& pointInMap) const;
    [[nodiscard]] bool open() const { return polygon.empty() && !(ceiling < 1e9); }
};

/// Whether @p place (base frame, seen from above) is on or within @p body's footprint, grown by @p margin
/// [m].
[[nodiscard]] bool onFootprint(const RobotBody& body, const Eigen::Vector2d& place, double margin);
/// Turns points of @p scan on or within @p body, grown by @p margin [m], into no echo.
void leaveOutBody(Scan& scan, const RobotBody& body, const Pose& sensorInBase, double margin = 0.05);
/// Turns points of @p scan outside @p crop into no echo.
void leaveOutCropped(Scan& scan, const MapCrop& crop, const Pose& scanInMap);

}  // namespace leitstand
