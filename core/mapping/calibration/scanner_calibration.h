#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include <Eigen/Core>

#include "core/mapping/calibration/range_bias.h"
#include "core/mapping/calibration/scanner_mount.h"
#include "core/robot/scanner_correction.h"

namespace leitstand {

/// What an advice is about: each is asked for itself.
enum class ScannerFault : std::uint8_t { Range, Lean, Clock, Mount };
/// The first one that @p more corrects.
[[nodiscard]] ScannerFault faultOf(const ScannerCorrection& more);
/// Whether an operator would be asked the same.
[[nodiscard]] bool asksAlike(const ScannerCorrection& a, const ScannerCorrection& b);

/// What the map tells of a scanner against what is said of it.
struct ScannerCalibration {
    std::optional<Estimated> range;                           ///< its ranges are too long by [m]
    Eigen::Vector2d lean = Eigen::Vector2d::Zero();           ///< roll and pitch in the base, beyond [rad]
    Eigen::Vector2d leanDeviation = Eigen::Vector2d::Zero();  ///< one deviation of each [rad]

    std::optional<MountError> mount = {};

    /// What is worth to be corrected and certain. Ranges come first: what is too long bends the floor, which
    /// looks like a lean; then the lean, the clock, and where it sits and looks.
    /// @p standing: was advised before, and is while it is not much less. @p left: what is not to be
    /// corrected.
    [[nodiscard]] std::optional<ScannerCorrection> advised(
        const std::optional<ScannerCorrection>& standing = {}, const std::set<ScannerFault>& left = {}) const;
};

}  // namespace leitstand
