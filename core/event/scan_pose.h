#pragma once

#include <cstdint>

#include "core/base/pose.h"

namespace leitstand {

/// Whether a key scan is used in the map.
enum class ScanTrust : std::uint8_t {
    Certain,    ///< it is part of the map, and others are registered against it
    Uncertain,  ///< it is shown, but nothing is built on it until the operator decides
    SetAside,   ///< it was rejected or rewound, and is not shown
};

/// Why a scan is uncertain, and other remarks about it: bits of ScanPose::doubts.
enum class ScanDoubt : std::uint8_t {
    Overlap = 1 << 0,    ///< too few of its points fit the map
    Residual = 1 << 1,   ///< the points that fit the map are too far from it
    Jump = 1 << 2,       ///< its pose contradicts the odometry
    Certainty = 1 << 3,  ///< its surfaces leave a direction of motion undetermined
    Diverged = 1 << 4,   ///< the registration did not converge
    Odometry = 1 << 5,   ///< it is unknown how the robot moved there
    Points = 1 << 6,     ///< it has too few points
    /// Odometry was missing during the scan; by itself, this does not make the scan uncertain.
    Guessed = 1 << 7,
};

/// Pose of a key scan and how certain it is.
struct ScanPose {
    std::uint64_t scan = 0;  ///< KeyScanSample::id
    Pose scanInMap = Pose::Identity();
    double rms = 0.0;          ///< root mean squared distance of the pairs [m]
    double inlierRatio = 0.0;  ///< IcpResult::inlierRatio, 0 to 1
    double overlap = 0.0;      ///< IcpResult::overlap, 0 to 1
    double certainty = 0.0;    ///< IcpResult::certainty, 0 to 1
    bool converged = false;
    ScanTrust trust = ScanTrust::Certain;
    std::uint8_t doubts = 0;  ///< bits of ScanDoubt
};

[[nodiscard]] constexpr bool has(std::uint8_t doubts, ScanDoubt doubt) {
    return (doubts & static_cast<std::uint8_t>(doubt)) != 0;
}

}  // namespace leitstand
