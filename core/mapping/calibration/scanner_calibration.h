#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include <Eigen/Core>

#include "core/mapping/calibration/range_bias.h"
#include "core/mapping/calibration/scanner_mount.h"
#include "core/robot/scanner_correction.h"

namespace leitstand {

/// The kind of fault that an advised correction removes. The operator is asked about each kind separately.
enum class ScannerFault : std::uint8_t { Range, Lean, Clock, Mount };
/// Returns the kind of fault that @p more corrects; of several, the first in the order of ScannerFault.
[[nodiscard]] ScannerFault faultOf(const ScannerCorrection& more);
/// Returns whether the operator would see no difference between advice @p a and advice @p b: the same fault
/// and nearly the same values.
[[nodiscard]] bool asksAlike(const ScannerCorrection& a, const ScannerCorrection& b);

/// What the map shows of a scanner whose measurements have the correction `present`.
struct ScannerFinding {
    ScannerCorrection present;
    std::optional<ScannerCorrection> more = {};  ///< advised on top of `present`; empty: none, or no longer
};

/// What the map shows of a scanner, compared with its configuration.
struct ScannerCalibration {
    std::optional<Estimated> range;  ///< by how much its ranges are too long [m]; empty: unknown
    /// Roll and pitch in the base, less the configured ones [rad].
    Eigen::Vector2d lean = Eigen::Vector2d::Zero();
    Eigen::Vector2d leanDeviation = Eigen::Vector2d::Zero();  ///< standard deviations of `lean` [rad]

    std::optional<MountError> mount = {};

    /// Returns the correction to advise, for one fault only: the first one that is large and certain enough.
    /// Empty: none. Ranges come first: ranges that are too long bend the floor, which looks like a lean. The
    /// lean, the clock and the mount follow.
    /// @p standing: the present advice, kept while the error is not much smaller. @p left: faults that are
    /// not to be corrected.
    [[nodiscard]] std::optional<ScannerCorrection> advised(
        const std::optional<ScannerCorrection>& standing = {}, const std::set<ScannerFault>& left = {}) const;
};

}  // namespace leitstand
