#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include <Eigen/Core>

#include "core/mapping/calibration/range_bias.h"
#include "core/mapping/calibration/scanner_mount.h"
#include "core/robot/scanner_correction.h"

namespace leitstand {

/// The fault that an advice corrects. The operator is asked about each one separately.
enum class ScannerFault : std::uint8_t { Range, Lean, Clock, Mount };
/// Returns the first fault that @p more corrects.
[[nodiscard]] ScannerFault faultOf(const ScannerCorrection& more);
/// Returns whether both ask the operator the same.
[[nodiscard]] bool asksAlike(const ScannerCorrection& a, const ScannerCorrection& b);

/// What the map finds about a scanner whose measurements have the correction @p present.
struct ScannerFinding {
    ScannerCorrection present;
    std::optional<ScannerCorrection> more = {};  ///< advised in addition; empty: none, or none any more
};

/// What the map shows of a scanner, compared with its configuration.
struct ScannerCalibration {
    std::optional<Estimated> range;  ///< its ranges are too long by [m]
    /// Roll and pitch in the base beyond the configured ones [rad].
    Eigen::Vector2d lean = Eigen::Vector2d::Zero();
    Eigen::Vector2d leanDeviation = Eigen::Vector2d::Zero();  ///< one deviation of each [rad]

    std::optional<MountError> mount = {};

    /// Returns the correction that is large and certain enough to be advised; empty: none. Ranges come first:
    /// ranges that are too long bend the floor, which looks like a lean. The lean, the clock and the mount
    /// follow.
    /// @p standing: the advice before, kept while the error is not much smaller. @p left: faults not to be
    /// corrected.
    [[nodiscard]] std::optional<ScannerCorrection> advised(
        const std::optional<ScannerCorrection>& standing = {}, const std::set<ScannerFault>& left = {}) const;
};

}  // namespace leitstand
