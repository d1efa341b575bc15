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

/// How the rows of an organised scan are oriented.
enum class Sweep : std::uint8_t {
    Tilting,  ///< a row is a raw scan from side to side at one tilt; columns are vertical profiles
    Yawing,   ///< a row is a vertical raw scan at one heading
};

/// One sweep of a 3D scanner, with the robot's motion removed. Immutable once shared.
struct Scan {
    std::string name;     ///< name for the operator, "scan000"
    std::string robot;    ///< "kurt3d"; empty when unknown
    Time start{}, end{};  ///< times of the first and last laser shot, robot's clock; epoch: unknown
    Pose sensorInOdom = Pose::Identity();  ///< pose at the end of the sweep, before registration
    bool hasOdometry = false;              ///< whether sensorInOdom was measured
    /// Number of raw scans, and of points in each (row by row); 0 x 0: unorganised.
    int rows = 0, columns = 0;
    Sweep sweep = Sweep::Tilting;         ///< meaning of the rows; valid only for organised scans
    std::vector<Eigen::Vector3f> points;  ///< in the sensor's frame at the end of the sweep [m]; NaN: no echo
    std::vector<float> intensities;       ///< empty, or one per point
    std::vector<Label> labels;            ///< empty, or one per point
    std::vector<std::uint8_t> shades;     ///< empty, or one per point: intensities for display (shadesOf())

    [[nodiscard]] bool organised() const { return rows > 0 && columns > 0; }
};
using ScanPtr = std::shared_ptr<const Scan>;

/// Points prepared for registration, all finite, in the frame of their scan.
struct PointCloud {
    std::vector<Eigen::Vector3f> points;   ///< [m]
    std::vector<Eigen::Vector3f> normals;  ///< empty, or one per point: unit length; zero: unknown
    std::vector<Label> labels;             ///< empty, or one per point
    std::vector<float> weights;  ///< empty, or one per point: how many measured points it stands for

    [[nodiscard]] std::size_t size() const { return points.size(); }
};

}  // namespace leitstand
