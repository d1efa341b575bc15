#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mission/coverage/coverage_settings.h"

namespace leitstand {

struct CameraInfoSample;

/// A kind of sensor that searches a place.
enum class SearchSensor : std::uint8_t { Scanner, Camera, Infrared };
inline constexpr std::array SearchSensors = {SearchSensor::Scanner, SearchSensor::Camera,
                                             SearchSensor::Infrared};
/// "scanner", "camera", "infrared".
[[nodiscard]] std::string_view nameOf(SearchSensor sensor);

/// What a camera can see, in its optical frame: a pyramid ahead, or a ring around its axis (cameras below
/// mirrors).
struct SearchField {
    double left = 0.0, right = 0.0, up = 0.0, down = 0.0;  ///< slopes of the pyramid's sides: x/z, y/z
    double inner = 0.0, outer = 0.0;  ///< angles of the ring's edges from the axis [rad]; outer 0: no ring
    double pixelsPerRadian = 0.0;

    /// Whether @p point (optical frame) is within the field.
    [[nodiscard]] bool holds(const Eigen::Vector3d& point) const;
    /// Returns the largest angle between the optical axis and a point in the field [rad].
    [[nodiscard]] double halfAngle() const;
};

/// Returns the field of @p camera; empty when it is not calibrated or its model is unknown.
[[nodiscard]] std::optional<SearchField> fieldOf(const CameraInfoSample& camera);

/// A pose from which a camera looked. It belongs to a key scan and moves with it in the map.
struct SearchView {
    std::uint64_t scan = 0;  ///< KeyScanSample::id
    SearchSensor sensor = SearchSensor::Camera;
    Pose cameraInScan = Pose::Identity();  ///< optical frame (z ahead) in the scan's frame
    SearchField field;
    Time seen{};  ///< when it looked, station's clock

    /// Returns the distance up to which the camera searches [m]: a lying body spans enough pixels, within the
    /// range limits of @p settings.
    [[nodiscard]] double range(const CoverageSettings& settings) const;
};

}  // namespace leitstand
