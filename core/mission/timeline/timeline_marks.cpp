#include "core/mission/timeline/timeline_marks.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/event/map_samples.h"
#include "core/event/status_samples.h"
#include "core/mission/finds/dismissal.h"
#include "core/mission/finds/find_book.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/fold.h"

namespace leitstand {
namespace {

std::string wordOf(FindSample::Status status) {
    switch (status) {
        case FindSample::Status::Hypothesis:
            return "hypothesis";
        case FindSample::Status::Confirmed:
            return "confirmed";
        case FindSample::Status::Discarded:
            break;
    }
    return "discarded";
}

std::string wordOf(FindSample::Kind kind) {
    switch (kind) {
        case FindSample::Kind::Victim:
            return "victim";
        case FindSample::Kind::Hazard:
            return "hazard";
        case FindSample::Kind::Code:
            return "code";
        case FindSample::Kind::Object:
            break;
    }
    return "object";
}

std::string wordOf(FindMove::Cause cause) {
    switch (cause) {
        case FindMove::Cause::Registration:
            return "registration";
        case FindMove::Cause::LoopClosure:
            return "loop closure";
        case FindMove::Cause::Operator:
            return "operator";
        case FindMove::Cause::Undo:
            break;
    }
    return "undo";
}

/// Returns the text of a code or a sign, otherwise the kinds of cues, each once.
std::string cuesOf(const CandidateSample& candidate) {
    std::vector<std::string> kinds;
    for (const Cue& cue : candidate.cues) {
        if (candidate.kind != FindSample::Kind::Victim && !cue.text.empty()) return cue.text;
        if (std::find(kinds.begin(), kinds.end(), cue.kind) == kinds.end()) kinds.push_back(cue.kind);
    }
    return fmt::format("{}", fmt::join(kinds, ", "));
}

}  // namespace

void TimelineCollector::put(const Event& event, TimelineMark mark) {
    if (mark.at == Time{}) mark.at = event.received;
    mark.sequence = event.sequence;
    m_marks.push_back(std::move(mark));
}

void TimelineCollector::addBumps(const Event& event, const BumpSample& bumps) {
    for (const Bumper& bumper : bumps.bumpers) {
        const auto [known, fresh] = m_hits.try_emplace({event.robot, bumper.name}, bumper.hits);
        // The first count may include hits before the mission. A falling count means a restart.
        const bool hit = fresh ? bumper.pressed : bumper.hits > known->second;
        known->second = bumper.hits;
        if (!hit) continue;
        put(event, {.kind = TimelineMark::Kind::Bump, .robot = event.robot, .key = bumper.name, .act = true});
    }
}

void TimelineCollector::addSightings(const Event& event, const SightingSample& sightings) {
    for (const Sighting& one : sightings.sightings) {
        if (!m_sightings.emplace(event.robot, one.id).second) continue;
        put(event,
            {.kind = TimelineMark::Kind::Sighting, .robot = event.robot, .key = one.kind, .text = one.text});
    }
}

void TimelineCollector::addCandidate(const Event& event, const CandidateSample& candidate) {
    // A candidate is published again whenever it moves, and with a lower confidence when it is taken back.
    const auto known = m_candidates.find(candidate.id);
    const bool shown = candidate.confidence >= LeastShownConfidence && candidate.victim == 0;
    if (candidate.dismissed && !isDismissal(candidate)) return;
    if (known == m_candidates.end() ? candidate.dismissed || !shown : known->second || !candidate.dismissed)
        return;
    m_candidates[candidate.id] = candidate.dismissed;
    put(event, {.kind = TimelineMark::Kind::Candidate,
                .robot = candidate.cues.empty() ? std::string() : candidate.cues.front().robot,
                .key = candidate.dismissed ? "dismissed" : "told",
                .name = wordOf(candidate.kind),
                .text = cuesOf(candidate),
                .candidate = candidate.id,
                .confidence = candidate.confidence});
}

void TimelineCollector::addMoves(const Event& event) {
    const bool matters = event.sample.is<FindSample>() || event.sample.is<KeyScanSample>() ||
                         event.sample.is<ScanPosesSample>() || event.sample.is<UndoSample>();
    if (!matters) return;
    m_mission = fold(std::move(m_mission), event);
    for (const FindMove& move : m_moves.follow(m_mission)) {
        put(event, {.kind = TimelineMark::Kind::Moved,
                    .key = wordOf(move.cause),
                    .name = nameOf(move.find.first, move.find.second),
                    .from = move.from,
                    .to = move.to});
    }
}

void TimelineCollector::add(const Event& event) {
    using Kind = TimelineMark::Kind;
    addMoves(event);
    if (const auto* victim = event.sample.as<FindSample>()) {
        const std::string name = nameOf(victim->kind, victim->number);
        const auto [known, fresh] = m_victims.try_emplace(name, victim->status);
        // Typing into a form is no moment to jump to; filing, confirming and discarding are.
        if (!fresh && known->second == victim->status) return;
        known->second = victim->status;
        put(event,
            {.kind = Kind::Victim, .robot = victim->robot, .key = wordOf(victim->status), .name = name});
    } else if (const auto* candidate = event.sample.as<CandidateSample>()) {
        addCandidate(event, *candidate);
    } else if (const auto* alarm = event.sample.as<AlarmSample>()) {
        if (alarm->state != AlarmSample::State::Raised) return;
        put(event, {.kind = Kind::Alarm,
                    .robot = alarm->robot,
                    .key = alarm->key,
                    .text = alarm->text,
                    .act = alarm->severity == AlarmSample::Severity::Critical});
    } else if (const auto* note = event.sample.as<NoteSample>()) {
        // A note written in a review refers to an earlier moment.
        const bool earlier = note->stamp != Time{} && note->stamp < event.received;
        put(event, {.kind = Kind::Note,
                    .at = earlier ? note->stamp : event.received,
                    .robot = note->robot,
                    .text = note->text});
    } else if (const auto* poses = event.sample.as<ScanPosesSample>()) {
        if (poses->cause == ScanPosesSample::Cause::Operator)
            put(event, {.kind = Kind::Decision, .key = "poses"});
    } else if (const auto* undo = event.sample.as<UndoSample>()) {
        const bool again = m_undos.contains(undo->event);
        if (!again) m_undos.insert(event.sequence);
        put(event, {.kind = Kind::Decision, .key = again ? "redo" : "undo", .text = undo->text});
    } else if (const auto* session = event.sample.as<SessionSample>()) {
        put(event, {.kind = Kind::Session, .key = session->start ? "start" : "end", .text = session->title});
    } else if (const auto* mode = event.sample.as<ModeSample>()) {
        std::string& before = m_modes[event.robot];
        if (before == mode->mode) return;
        before = mode->mode;
        put(event, {.kind = Kind::Mode, .robot = event.robot, .key = mode->mode, .text = mode->reason});
    } else if (const auto* bumps = event.sample.as<BumpSample>()) {
        addBumps(event, *bumps);
    } else if (const auto* sightings = event.sample.as<SightingSample>()) {
        addSightings(event, *sightings);
    }
}

std::vector<TimelineMark> TimelineCollector::marks() const {
    std::vector<TimelineMark> sorted = m_marks;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const TimelineMark& a, const TimelineMark& b) { return a.at < b.at; });
    return sorted;
}

void dropUndone(std::vector<TimelineMark>& marks, const MissionState& mission) {
    std::erase_if(marks, [&mission](const TimelineMark& mark) {
        if (mark.kind != TimelineMark::Kind::Note) return false;
        const Decision* const note = decisionAt(mission, mark.sequence);
        return note != nullptr && note->undone;
    });
}

const TimelineMark* markAfter(const std::vector<TimelineMark>& marks, Time at) {
    const auto found = std::upper_bound(marks.begin(), marks.end(), at,
                                        [](Time time, const TimelineMark& mark) { return time < mark.at; });
    return found == marks.end() ? nullptr : &*found;
}

const TimelineMark* markBefore(const std::vector<TimelineMark>& marks, Time at) {
    const auto found = std::lower_bound(marks.begin(), marks.end(), at,
                                        [](const TimelineMark& mark, Time time) { return mark.at < time; });
    return found == marks.begin() ? nullptr : &*std::prev(found);
}

}  // namespace leitstand
