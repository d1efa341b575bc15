#include "app/services/team/shared_evidence.h"

#include <algorithm>
#include <vector>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/sample.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {
namespace {

/// For evidence or cues.
template <class Look>
bool takeSequences(std::vector<Look>& looks, const std::vector<Look>& ours) {
    bool any = false;
    for (Look& look : looks) {
        if (look.sequence != 0) continue;
        const auto same = std::find_if(ours.begin(), ours.end(), [&](const Look& one) {
            return one.kind == look.kind && one.topic == look.topic && one.stamp == look.stamp;
        });
        if (same == ours.end() || same->sequence == 0) continue;
        look.sequence = same->sequence;
        any = true;
    }
    return any;
}

}  // namespace

Sample forOthers(Sample sample) {
    if (auto* find = sample.edit<FindSample>()) {
        for (VictimEvidence& one : find->evidence) one.sequence = 0;
    } else if (auto* candidate = sample.edit<CandidateSample>()) {
        for (Cue& cue : candidate->cues) cue.sequence = 0;
    }
    return sample;
}

bool takeOurSequences(Sample& sample, const MissionState& mission) {
    if (auto* find = sample.edit<FindSample>()) {
        const auto known = mission.finds->find({find->kind, find->number});
        return known != mission.finds->end() && takeSequences(find->evidence, known->second.victim.evidence);
    }
    if (auto* candidate = sample.edit<CandidateSample>()) {
        const auto known = mission.candidates->find(candidate->id);
        return known != mission.candidates->end() &&
               takeSequences(candidate->cues, known->second.candidate.cues);
    }
    return false;
}

}  // namespace leitstand
