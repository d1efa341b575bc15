#include "core/mission/finds/dismissal.h"

#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

bool isDismissal(const CandidateSample& sample, const CandidateSettings& settings) {
    return sample.dismissed && !sample.cues.empty() && sample.confidence >= settings.publishFrom;
}

CandidateSample judged(CandidateSample candidate, bool dismissed, const std::string& station, Time now,
                       const CandidateSettings& settings) {
    candidate.dismissed = dismissed;
    candidate.station = station;
    candidate.stamp = now;
    // At least the confidence to publish: less would be taken for a book's own doubt.
    if (dismissed && !(candidate.confidence >= settings.publishFrom))
        candidate.confidence = settings.publishFrom;
    return candidate;
}

const CandidateSample* newestDismissal(const MissionState& state, const std::string& station,
                                       std::uint64_t after) {
    const CandidateSample* newest = nullptr;
    for (const auto& [id, entry] : *state.candidates) {
        const CandidateSample& one = entry.candidate;
        if (one.station != station || entry.sequence <= after || !isDismissal(one)) continue;
        after = entry.sequence;
        newest = &one;
    }
    return newest;
}

}  // namespace leitstand
