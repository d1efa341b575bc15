#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"

namespace leitstand {

/// What a point belongs to (paper, section 2.2: blue, yellow, red).
enum class Label : std::uint8_t { Unlabelled, Floor, Wall, Ceiling };
inline constexpr int LabelCount = 4;

/// How the rows of an organised scan lie in space.
enum class Sweep : std::uint8_t {
    Tilting,  ///< a row is a raw scan from side to side, at one tilt: columns are the vertical profiles
    Yawing,   ///< a row is a vertical raw scan, taken at one heading
};

/// One sweep of a 3D scanner with the motion of its robot taken out. Immutable once shared.
struct Scan {
    std::string name;                      ///< "scan000": what the operator sees
    std::string robot;                     ///< "kurt3d"; empty when unknown
    Time start{}, end{};                   ///< first and last laser shot, robot's clock; epoch when unknown
    Pose sensorInOdom = Pose::Identity();  ///< at the end of the sweep, before registration
    bool hasOdometry = false;              ///< whether sensorInOdom was measured
    int rows = 0, columns = 0;             ///< raw scans, points in each (row-major); 0 x 0 when unorganised
    Sweep sweep = Sweep::Tilting;          ///< meaning of the rows; only where organised
    std::vector<Eigen::Vector3f> points;  ///< in the sensor's frame at the end of the sweep [m]; NaN: no echo
    std::vector<float> intensities;       ///< empty, or one per point
    std::vector<Label> labels;            ///< empty, or one per point
    std::vector<std::uint8_t> shades;     ///< empty, or one per point: intensities for display (shadesOf())

    [[nodiscard]] bool organised() const { return rows > 0 && columns > 0; }
};
using ScanPtr = std::shared_ptr<const Scan>;

/// Points prepared for registration, all finite, in their scan's frame.
struct PointCloud {
    std::vector<Eigen::Vector3f> points;   ///< [m]
    std::vector<Eigen::Vector3f> normals;  ///< empty, or one per point: unit length, or zero where unknown
    std::vector<Label> labels;             ///< empty, or one per point
    std::vector<float> weights;  ///< empty, or one per point: number of measured points that it stands for

    [[nodiscard]] std::size_t size() const { return points.size(); }
};

}  // namespace leitstand
