#pragma once

#include "core/base/pose.h"

namespace leitstand {

struct CloudSample;

/// Corrections of a 3D scanner's measurements, and of its mount as it is given in the robot's file.
struct ScannerCorrection {
    static constexpr double MostRange = 0.2;         ///< limit of `range` [m]
    static constexpr double MostLean = degrees(10);  ///< limit of `roll` and `pitch` [rad]
    static constexpr double MostShift = 0.2;         ///< limit of `x` and `y` [m]
    static constexpr double MostTurn = degrees(20);  ///< limit of `yaw` [rad]
    static constexpr double MostClock = 0.5;         ///< limit of `clock` [s]

    double range = 0.0;              ///< added to all ranges [m]
    double roll = 0.0, pitch = 0.0;  ///< tilt in the base, in addition to the given mount [rad]
    double x = 0.0, y = 0.0;         ///< shift ahead (x) and to the left (y) in the base [m] ...
    double yaw = 0.0;                ///< ... and turn to the left [rad]
    double clock = 0.0;              ///< added to the scanner's stamps [s]

    [[nodiscard]] bool isNone() const { return *this == ScannerCorrection{}; }
    /// Returns the sum of this correction and @p more, each value within its limit.
    [[nodiscard]] ScannerCorrection with(const ScannerCorrection& more) const;
    /// Returns the corrected pose of a scanner whose pose in the robot's file is @p sensorInBase.
    [[nodiscard]] Pose corrected(const Pose& sensorInBase) const;
    /// Corrects the stamp and the points of @p cloud. Each point must be in the scanner's frame at the time
    /// of its shot. Points that would move behind the scanner are put at its origin.
    void correct(CloudSample& cloud) const;

    friend bool operator==(const ScannerCorrection&, const ScannerCorrection&) = default;
};

}  // namespace leitstand
