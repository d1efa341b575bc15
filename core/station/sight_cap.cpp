#include "core/station/sight_cap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr double Never = std::numeric_limits<double>::infinity();

double factorOf(double age, const SightRules& rules) {
    return age < rules.full ? 1.0 : age < rules.creep ? rules.creepShare : 0.0;
}

}  // namespace

SightCap sightCap(const SightAges& ages, bool overridden, const SightRules& rules) {
    SightCap cap;
    if (!ages.camera && !ages.scanner) {
        cap.reason = SightReason::NoEyes;
        cap.overridden = overridden;
        return cap;
    }
    const double picture = ages.camera ? ages.picture.seconds() : Never;
    const double scan = ages.scanner && ages.ahead < rules.turn ? ages.scan : Never;
    cap.factor = factorOf(std::min(picture, scan), rules);
    cap.age = picture;
    if (picture < rules.full) {
        cap.reason = SightReason::Fresh;
    } else if (!ages.camera) {
        cap.reason = scan < rules.full ? SightReason::Fresh : SightReason::OldScan;
        cap.age = ages.scan < rules.full ? ages.ahead : ages.scan;
    } else if (factorOf(scan, rules) > factorOf(picture, rules)) {
        cap.reason = SightReason::ScanAlone;
    } else if (!std::isfinite(picture)) {
        cap.reason = SightReason::NoPicture;
    } else {
        cap.reason = ages.picture.isFrozen(rules.full) ? SightReason::FrozenPicture : SightReason::OldPicture;
    }
    cap.overridden = overridden;
    if (overridden) cap.factor = 1.0;
    return cap;
}

double scanAgeAlong(const VirtualScanView& view, const DriveVelocity& velocity) {
    const bool onTheSpot = velocity.forward == 0.0 && velocity.left == 0.0 && velocity.turn != 0.0;
    const double half = degrees(onTheSpot ? 90.0 : 30.0);
    const double direction = onTheSpot ? 0.0 : std::atan2(velocity.left, velocity.forward);
    if (view.sectors.empty()) return Never;
    std::vector<double> ages;
    for (std::size_t i = 0; i < view.sectors.size(); ++i) {
        const double aside = std::remainder(view.directionOf(static_cast<int>(i)) - direction, degrees(360));
        if (std::abs(aside) <= half) ages.push_back(view.sectors[i].age);
    }
    if (ages.empty()) return view.sectors[static_cast<std::size_t>(view.sectorOf(direction))].age;
    const auto oldest = ages.begin() + static_cast<std::ptrdiff_t>(9 * (ages.size() - 1) / 10);
    std::nth_element(ages.begin(), oldest, ages.end());
    return *oldest;
}

DriveVelocity capped(const DriveVelocity& velocity, const SightCap& cap, const DriveLimits& limits) {
    const double factor = std::clamp(cap.factor, 0.0, 1.0);  // NaN becomes none below
    if (!(factor > 0.0)) return {};
    return limited(velocity, {factor * limits.speed, factor * limits.turnRate, limits.sideways});
}

}  // namespace leitstand
