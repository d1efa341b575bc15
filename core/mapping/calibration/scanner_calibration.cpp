#include "core/mapping/calibration/scanner_calibration.h"

#include <algorithm>
#include <cmath>

namespace leitstand {
namespace {

constexpr double NoticedRange = 0.01;         ///< smaller ones may come from distorted turns [m]
constexpr double NoticedLean = degrees(0.2);  ///< [rad]
constexpr double NoticedShift = 0.01;         ///< [m]
constexpr double NoticedTurn = degrees(0.3);  ///< of its heading [rad]
constexpr double NoticedClock = 0.02;         ///< [s]
constexpr double Sigmas = 3.0;                ///< a certain value is larger than so many deviations
constexpr double Stands = 0.7;                ///< share of these bounds that keeps a standing advice
constexpr double SureRange = 0.003;           ///< largest deviation of a range estimate [m]
constexpr double SureClock = 0.005;           ///< largest deviation of a clock estimate [s] ...
constexpr double SureShare = 0.1;             ///< ... or share of the estimate, the larger of both

}  // namespace

std::optional<ScannerCorrection> ScannerCalibration::advised(const std::optional<ScannerCorrection>& standing,
                                                             const std::set<ScannerFault>& left) const {
    const auto shareFor = [&](ScannerFault fault) {
        return standing && faultOf(*standing) == fault ? Stands : 1.0;
    };
    const bool sureRange = range && range->deviation <= SureRange;
    ScannerCorrection more;
    double share = shareFor(ScannerFault::Range);
    if (sureRange && !left.contains(ScannerFault::Range) && std::abs(range->value) >= share * NoticedRange) {
        more.range = -range->value;
        return more;
    }
    share = shareFor(ScannerFault::Lean);
    const double leans = lean.norm();
    if (sureRange && !left.contains(ScannerFault::Lean) && lean.allFinite() && leans >= share * NoticedLean &&
        leans >= share * Sigmas * leanDeviation.norm()) {
        more.roll = lean.x();
        more.pitch = lean.y();
        return more;
    }
    if (!mount) return std::nullopt;
    const auto noticed = [&](int i, double least, double of) {
        const double off = std::abs(mount->value[i]);
        return off >= of * least && off >= of * Sigmas * mount->deviation[i];
    };
    share = shareFor(ScannerFault::Clock);
    if (!left.contains(ScannerFault::Clock) && noticed(3, NoticedClock, share)) {
        // Advice on the mount waits for the clock.
        const double late = mount->value[3];
        if (share * mount->deviation[3] > std::max(SureClock, SureShare * std::abs(late)))
            return std::nullopt;
        more.clock = -late;
        return more;
    }
    if (left.contains(ScannerFault::Mount)) return std::nullopt;
    // Values of the mount that are not certain stay as configured.
    const auto stands = [&](double ScannerCorrection::*of) {
        return standing && (*standing).*of != 0.0 ? Stands : 1.0;
    };
    if (noticed(0, NoticedShift, stands(&ScannerCorrection::x))) more.x = mount->value[0];
    if (noticed(1, NoticedShift, stands(&ScannerCorrection::y))) more.y = mount->value[1];
    if (noticed(2, NoticedTurn, stands(&ScannerCorrection::yaw))) more.yaw = mount->value[2];
    return more.isNone() ? std::nullopt : std::optional(more);
}

ScannerFault faultOf(const ScannerCorrection& more) {
    if (more.range != 0.0) return ScannerFault::Range;
    if (more.roll != 0.0 || more.pitch != 0.0) return ScannerFault::Lean;
    return more.clock != 0.0 ? ScannerFault::Clock : ScannerFault::Mount;
}

bool asksAlike(const ScannerCorrection& a, const ScannerCorrection& b) {
    constexpr double Range = 0.002, Angle = degrees(0.05), Shift = 0.002, Clock = 0.005;
    return faultOf(a) == faultOf(b) && std::abs(a.range - b.range) < Range &&
           std::abs(a.roll - b.roll) < Angle && std::abs(a.pitch - b.pitch) < Angle &&
           std::abs(a.x - b.x) < Shift && std::abs(a.y - b.y) < Shift && std::abs(a.yaw - b.yaw) < Angle &&
           std::abs(a.clock - b.clock) < Clock;
}

}  // namespace leitstand
