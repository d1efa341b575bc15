#pragma once

#include "core/base/pose.h"

namespace leitstand {

struct CloudSample;

/// Corrections of a 3D scanner's measurements and of its mount as stated in the robot's file.
struct ScannerCorrection {
    static constexpr double MostRange = 0.2;         ///< [m]
    static constexpr double MostLean = degrees(10);  ///< [rad]
    static constexpr double MostShift = 0.2;         ///< [m]
    static constexpr double MostTurn = degrees(20);  ///< of its heading [rad]
    static constexpr double MostClock = 0.5;         ///< [s]

    double range = 0.0;              ///< added to all ranges of the scanner [m]
    double roll = 0.0, pitch = 0.0;  ///< tilt in the base in addition to the stated mount [rad]
    double x = 0.0, y = 0.0;         ///< shift ahead (x) and to the left (y) in the base [m] ...
    double yaw = 0.0;                ///< ... and turn to the left [rad]
    double clock = 0.0;              ///< added to the scanner's stamps [s]

    [[nodiscard]] bool isNone() const { return *this == ScannerCorrection{}; }
    /// Returns this correction and @p more together, each value within its limit.
    [[nodiscard]] ScannerCorrection with(const ScannerCorrection& more) const;
    /// Returns the corrected pose of a scanner whose stated mount is @p sensorInBase.
    [[nodiscard]] Pose corrected(const Pose& sensorInBase) const;
    /// Corrects the stamp and the points of @p cloud. Each point must be in the scanner's frame at the time
    /// of its shot. Points that would come to lie behind the scanner are put at its origin.
    void correct(CloudSample& cloud) const;

    friend bool operator==(const ScannerCorrection&, const ScannerCorrection&) = default;
};

}  // namespace leitstand
