#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include <Eigen/Core>

#include "core/mapping/calibration/range_bias.h"
#include "core/mapping/calibration/scanner_mount.h"
#include "core/robot/scanner_correction.h"

namespace leitstand {

/// The kind of fault that a suggested correction removes. The operator is asked about each kind separately.
enum class ScannerFault : std::uint8_t { Range, Lean, Clock, Mount };
/// Returns the kind of fault that @p more corrects. If it corrects several, returns the first in the order of
/// ScannerFault.
[[nodiscard]] ScannerFault faultOf(const ScannerCorrection& more);
/// Returns whether the suggestions @p a and @p b are the same for the operator: the same fault and nearly the
/// same values.
[[nodiscard]] bool asksAlike(const ScannerCorrection& a, const ScannerCorrection& b);

/// A correction that a scanner uses (`present`), and what the map still shows of its errors.
struct ScannerFinding {
    ScannerCorrection present;
    /// Suggested in addition to `present`; empty: none, or no longer.
    std::optional<ScannerCorrection> more = {};
};

/// What the map shows of a scanner, compared with its configuration.
struct ScannerCalibration {
    std::optional<Estimated> range;  ///< by how much ranges are too long [m]; empty: unknown
    /// Roll and pitch in the base, minus the configured values [rad].
    Eigen::Vector2d lean = Eigen::Vector2d::Zero();
    Eigen::Vector2d leanDeviation = Eigen::Vector2d::Zero();  ///< standard deviations of `lean` [rad]

    std::optional<MountError> mount = {};

    /// Returns the correction to suggest. It corrects one fault only: the first that is large and certain
    /// enough. Empty: none. Ranges come first, because ranges that are too long bend the floor, which looks
    /// like a lean. The lean, the clock and the mount follow.
    /// @p standing: the present suggestion, which is kept unless the error has become much smaller. @p left:
    /// faults that shall not be corrected.
    [[nodiscard]] std::optional<ScannerCorrection> advised(
        const std::optional<ScannerCorrection>& standing = {}, const std::set<ScannerFault>& left = {}) const;
};

}  // namespace leitstand
