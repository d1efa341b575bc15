#include "core/handin/report_work.h"

#include <algorithm>
#include <variant>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

bool isOfPeople(const Decision& decision) {
    if (decision.undone) return false;
    const auto* const poses = std::get_if<ScanPosesSample>(&decision.content);
    return std::holds_alternative<MapCropSample>(decision.content) ||
           (poses != nullptr && poses->cause == ScanPosesSample::Cause::Operator);
}

}  // namespace

ReportWork workOf(const MissionState& state) {
    ReportWork work;
    work.mappedLive = !state.keyScans->empty();
    std::set<FindKey> believed;
    for (const auto& [id, entry] : *state.candidates) {
        const CandidateSample& candidate = entry.candidate;
        if (!(candidate.confidence >= LeastShownConfidence)) continue;
        ++work.believed;
        for (const Cue& cue : candidate.cues) work.cues.insert(cue.kind);
        const bool sighted = std::any_of(candidate.cues.begin(), candidate.cues.end(),
                                         [](const Cue& cue) { return cue.kind == "sighting"; });
        work.sighted += sighted ? 1 : 0;
        if (candidate.victim != 0) believed.insert({candidate.kind, candidate.victim});
    }
    work.cues.erase("sighting");  // that is the robot's work
    work.scanDecisions = static_cast<std::size_t>(
        std::count_if(state.decisions->begin(), state.decisions->end(), &isOfPeople));
    for (const auto& [key, entry] : *state.finds) {
        if (entry.victim.status == FindSample::Status::Discarded) continue;
        ++work.filed;
        if (believed.contains(key)) ++work.fromCandidates;
        if (entry.victim.status == FindSample::Status::Confirmed) ++work.confirmed;
    }
    return work;
}

}  // namespace leitstand
