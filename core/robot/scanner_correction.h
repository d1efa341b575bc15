#pragma once

#include "core/base/pose.h"
#include "core/event/cloud_sample.h"

namespace leitstand {

/// What is known of a 3D scanner beyond what it measures and where its mount is said to be.
struct ScannerCorrection {
    static constexpr double MostRange = 0.2;         ///< [m]
    static constexpr double MostLean = degrees(10);  ///< [rad]
    static constexpr double MostShift = 0.2;         ///< [m]
    static constexpr double MostTurn = degrees(20);  ///< of its heading [rad]
    static constexpr double MostClock = 0.5;         ///< [s]

    double range = 0.0;              ///< to be added to all its ranges [m]
    double roll = 0.0, pitch = 0.0;  ///< it leans by that in the base, beyond its mount [rad]
    double x = 0.0, y = 0.0;         ///< it sits so much farther ahead and to the left in the base [m] ...
    double yaw = 0.0;                ///< ... and is turned to the left by that [rad]
    double clock = 0.0;              ///< to be added to its stamps [s]

    [[nodiscard]] bool isNone() const { return *this == ScannerCorrection{}; }
    /// This and @p more on top of it.
    [[nodiscard]] ScannerCorrection with(const ScannerCorrection& more) const;
    /// Where a scanner sits whose mount is said to be @p sensorInBase.
    [[nodiscard]] Pose corrected(const Pose& sensorInBase) const;
    /// Puts the points of @p cloud, each in the frame of the scanner when it saw it, to where they are, and
    /// its stamp to when.
    /// Points that would come to lie behind the scanner lie in it.
    void correct(CloudSample& cloud) const;

    friend bool operator==(const ScannerCorrection&, const ScannerCorrection&) = default;
};

}  // namespace leitstand
