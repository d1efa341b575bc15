#include "core/mission/finds/ruled_out.h"

#include <algorithm>
#include <cmath>

namespace leitstand {
namespace {

constexpr double Surely = 0.6;  // warmth of this confidence is a person's, not a lit wall's

bool wasWarm(const CandidateThing& thing) {
    return std::any_of(thing.looks.begin(), thing.looks.end(), [](const auto& look) {
        const std::string& kind = std::get<0>(look.first);
        return kind == "heat" || kind == "sighting";
    });
}

double surestHeat(const CandidateThing& thing) {
    double surest = 0.0;
    for (const auto& [key, look] : thing.looks) {
        if (std::get<0>(key) == "heat") surest = std::max(surest, look.strongest);
    }
    return surest;
}

}  // namespace

bool isOfRuledOut(const PlacedCue& cue, const CandidateThing& thing, const CandidateSettings& settings) {
    if (cue.cue.kind == "heat" && cue.cue.confidence >= Surely && !wasWarm(thing)) return false;
    if (cue.cue.kind == "tag" && thing.tag() != cue.cue.text) return false;
    const double away = (cue.inMap - thing.inMap).head<2>().norm();
    if (away < settings.ruledOut) return true;
    return away < settings.sameVictim &&
           squaredDeviations(cue.inMap - thing.inMap, cue.covariance + thing.covariance) <
               settings.ruledOutGate * settings.ruledOutGate;
}

bool isRuledOutAgain(const CandidateThing& made, const CandidateThing& thing,
                     const CandidateSettings& settings) {
    if (surestHeat(made) >= Surely && !wasWarm(thing)) return false;
    if (!made.tag().empty() && made.tag() != thing.tag()) return false;
    return (made.inMap - thing.inMap).head<2>().norm() < settings.ruledOut;
}

}  // namespace leitstand
