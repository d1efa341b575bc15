#include "core/mapping/calibration/scanner_calibration.h"

#include <cmath>

namespace leitstand {
namespace {

constexpr double NoticedRange = 0.01;         ///< what is less may come of how turns are bent [m]
constexpr double NoticedLean = degrees(0.2);  ///< [rad]
constexpr double Sigmas = 3.0;                ///< what is told is certain by so many deviations
constexpr double Stands = 0.7;                ///< of that, for what was told
constexpr double SureRange = 0.003;           ///< an estimate that scatters more is none [m]

}  // namespace

std::optional<ScannerCorrection> ScannerCalibration::advised(bool standing) const {
    const double share = standing ? Stands : 1.0;
    if (!range || range->deviation > SureRange) return std::nullopt;
    if (std::abs(range->value) >= share * NoticedRange) return ScannerCorrection{-range->value, 0.0, 0.0};
    const double leans = lean.norm();
    if (!lean.allFinite() || leans < share * NoticedLean || leans < share * Sigmas * leanDeviation.norm())
        return std::nullopt;
    return ScannerCorrection{0.0, lean.x(), lean.y()};
}

}  // namespace leitstand
