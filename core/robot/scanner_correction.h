#pragma once

#include "core/base/pose.h"

namespace leitstand {

struct CloudSample;

/// Corrections of a 3D scanner's measurements and of its stated mount.
struct ScannerCorrection {
    static constexpr double MostRange = 0.2;         ///< [m]
    static constexpr double MostLean = degrees(10);  ///< [rad]
    static constexpr double MostShift = 0.2;         ///< [m]
    static constexpr double MostTurn = degrees(20);  ///< of its heading [rad]
    static constexpr double MostClock = 0.5;         ///< [s]

    double range = 0.0;              ///< added to all its ranges [m]
    double roll = 0.0, pitch = 0.0;  ///< lean in the base, beyond its mount [rad]
    double x = 0.0, y = 0.0;         ///< shift ahead and to the left in the base [m] ...
    double yaw = 0.0;                ///< ... and turn to the left [rad]
    double clock = 0.0;              ///< added to its stamps [s]

    [[nodiscard]] bool isNone() const { return *this == ScannerCorrection{}; }
    /// Returns this correction with @p more on top of it.
    [[nodiscard]] ScannerCorrection with(const ScannerCorrection& more) const;
    /// Returns the pose of a scanner whose stated mount is @p sensorInBase.
    [[nodiscard]] Pose corrected(const Pose& sensorInBase) const;
    /// Corrects the points of @p cloud, each in the frame of the scanner when it saw the point, and its
    /// stamp.
    /// Points that would come to lie behind the scanner are put at its origin.
    void correct(CloudSample& cloud) const;

    friend bool operator==(const ScannerCorrection&, const ScannerCorrection&) = default;
};

}  // namespace leitstand
