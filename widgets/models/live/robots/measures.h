#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct ModelBody;

/// Where a sensor sits.
struct SensorPlace {
    std::string name, frame;
    Pose sensorInBase = Pose::Identity();
};

/// How large a robot is and where its sensors sit, as the operator enters it.
struct Measures {
    std::vector<Eigen::Vector2d> footprint;  ///< in the base frame, counter-clockwise [m]
    double height = 0.0;                     ///< [m]
    std::vector<SensorPlace> sensors;        ///< by their names
};

/// Returns what the file of @p robot says. Sensors that streams name, and the file does not place, are at the
/// base.
[[nodiscard]] Measures measuresOf(const RobotDescription& robot);

/// How far a rectangular robot reaches from its base frame [m].
struct Sides {
    double front = 0.0, rear = 0.0, left = 0.0, right = 0.0;  ///< from the base; positive outwards
    friend bool operator==(const Sides&, const Sides&) = default;
};
/// Returns how far @p footprint reaches.
[[nodiscard]] Sides sidesOf(const std::vector<Eigen::Vector2d>& footprint);
/// Whether @p footprint is a rectangle along the axes.
[[nodiscard]] bool isRectangle(const std::vector<Eigen::Vector2d>& footprint);
[[nodiscard]] std::vector<Eigen::Vector2d> footprintOf(const Sides& sides);

/// Returns @p measures with those of a robot's model: footprint and height if extentOf() tells them, and the
/// places of sensors whose frames are links of it. @p problem: why footprint and height stay; empty: they do
/// not.
[[nodiscard]] Measures withModel(Measures measures, const ModelBody& body, std::string& problem);

}  // namespace leitstand
