#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/mapping/calibration/range_bias.h"
#include "core/robot/scanner_correction.h"

namespace leitstand {

/// What the map tells of a scanner against what is said of it.
struct ScannerCalibration {
    std::optional<Estimated> range;                           ///< its ranges are too long by [m]
    Eigen::Vector2d lean = Eigen::Vector2d::Zero();           ///< roll and pitch in the base, beyond [rad]
    Eigen::Vector2d leanDeviation = Eigen::Vector2d::Zero();  ///< one deviation of each [rad]

    /// What is worth to be corrected and certain. Ranges come first: what is too long bends the floor, which
    /// looks like a lean.
    /// @p standing: it was advised before, and is while it is not much less.
    [[nodiscard]] std::optional<ScannerCorrection> advised(bool standing = false) const;
};

}  // namespace leitstand
