#include "core/mission/finds/behind.h"

#include <cmath>

namespace leitstand {
namespace {

constexpr double NearlyAll = 0.8;  // of the evidence

}  // namespace

std::optional<double> sharePassing(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                   const Eigen::Vector3d& body, const CandidateSettings& settings) {
    if (!from.allFinite() || !to.allFinite()) return std::nullopt;
    const Eigen::Vector2d ray = (to - from).head<2>(), there = (body - from).head<2>();
    const double length = ray.norm();
    if (!(length > settings.behind)) return std::nullopt;
    const double along = there.dot(ray) / length;
    const double beside = std::abs(there.x() * ray.y() - there.y() * ray.x()) / length;
    if (along <= 0.0 || along + settings.behind > length || beside > settings.beside) return std::nullopt;
    // A ray that passes well above or below the body shows something else.
    const double passes = from.z() + along / length * (to.z() - from.z());
    if (std::abs(passes - body.z()) > settings.above) return std::nullopt;
    return along / length;
}

bool isSeenPast(const CandidateThing& far, const CandidateThing& nearer, const ScanPlaces& scans,
                const CandidateSettings& settings) {
    double all = 0.0, past = 0.0;
    for (const auto& [key, look] : far.looks) {
        const std::string& kind = std::get<0>(key);
        if (kind != "heat" && kind != "motion" && kind != "sighting") continue;
        all += look.evidence;
        const auto scan = scans.find(std::get<2>(key));
        const Pose pose = scan == scans.end() ? Pose::Identity() : scan->second;
        if (sharePassing(pose * look.fromInScan, pose * look.inScan, nearer.inMap, settings))
            past += look.evidence;
    }
    return past > 0.0 && past >= NearlyAll * all;
}

}  // namespace leitstand
