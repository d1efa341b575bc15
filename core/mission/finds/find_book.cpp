#include "core/mission/finds/find_book.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/scan_pose.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/scan_state.h"

namespace leitstand {
namespace {

using Status = FindSample::Status;
using SignState = VictimSign::State;

constexpr double Storey = 2.0;   ///< what is higher above a floor is not on it [m]
constexpr double InSight = 4.0;  ///< range within which a scan shows a place well enough to hang it on [m]

const FindSample* find(const MissionState& state, const FindKey& key) {
    const auto found = state.finds->find(key);
    return found == state.finds->end() ? nullptr : &found->second.victim;
}

void publishPresent(VictimSign& sign, double value) {
    if (sign.state == SignState::Unknown) sign.state = SignState::Present;
    if (std::isnan(sign.value) && sign.state == SignState::Present) sign.value = value;
}

void addEvidence(FindSample& to, const std::vector<VictimEvidence>& from) {
    for (const VictimEvidence& one : from) {
        const auto known =
            std::find_if(to.evidence.begin(), to.evidence.end(), [&](const VictimEvidence& there) {
                const bool numbered = there.sequence != 0 && one.sequence != 0;
                return there.topic == one.topic &&
                       (numbered ? there.sequence == one.sequence : there.stamp == one.stamp);
            });
        if (known == to.evidence.end())
            to.evidence.push_back(one);
        else if (known->sequence == 0)
            known->sequence = one.sequence;  // another station's log did not hold it
    }
}

/// Adds what @p frozen measured, where nothing else is known.
void addSigns(FindSample& to, const FrozenEvidence& frozen) {
    if (to.kind == FindSample::Kind::Victim) {
        if (!std::isnan(frozen.heat)) publishPresent(to.heat, frozen.heat);
        if (!std::isnan(frozen.co2)) publishPresent(to.co2, frozen.co2);
        if (frozen.motion) publishPresent(to.motion, Unknown);
    }
    if (to.tag.empty()) to.tag = frozen.tag;
}

void fill(VictimSign& to, const VictimSign& from) {
    if (to.state == SignState::Unknown && from.state != SignState::Unknown) to = from;
}
void fill(std::string& to, const std::string& from) {
    if (to.empty()) to = from;
}

void fill(FindSample& to, const FindSample& from) {
    fill(to.form, from.form);
    fill(to.motion, from.motion);
    fill(to.heat, from.heat);
    fill(to.sound, from.sound);
    fill(to.co2, from.co2);
    fill(to.situation, from.situation);
    fill(to.tag, from.tag);
    fill(to.area, from.area);
    fill(to.text, from.text);
    addEvidence(to, from.evidence);
}

std::optional<FindSample> changed(const MissionState& state, const FindKey& key, const std::string& station,
                                  Time now) {
    const FindSample* known = find(state, key);
    if (known == nullptr) return std::nullopt;
    FindSample sample = *known;
    sample.station = station;
    // Clocks of stations differ, so a later change always gets a later stamp.
    sample.stamp = std::max(now, known->stamp + std::chrono::nanoseconds(1));
    return sample;
}

FindSample fresh(const MissionState& state, FindSample::Kind kind, const std::string& station, Time now) {
    FindSample sample;
    sample.kind = kind;
    sample.number = nextNumber(state, kind);
    sample.station = station;
    sample.stamp = sample.found = now;
    return sample;
}

/// Whether finds with the texts @p one and @p other may be the same: signs with different texts are two,
/// however near.
bool mayBeOne(FindSample::Kind kind, const std::string& one, const std::string& other) {
    const bool sign = kind == FindSample::Kind::Code || kind == FindSample::Kind::Hazard;
    return !sign || one.empty() || other.empty() || one == other;
}

/// Adds the scan that a find hangs on as evidence, when no scan was frozen.
void addScan(FrozenEvidence& frozen, const MissionState& state) {
    const auto known = state.keyScans->find(frozen.scan);
    const bool there = std::any_of(frozen.evidence.begin(), frozen.evidence.end(),
                                   [](const VictimEvidence& one) { return one.kind == "scan"; });
    if (there || known == state.keyScans->end()) return;
    const KeyScanState& scan = known->second;
    frozen.evidence.push_back(
        {"scan", std::string(station_topic::KeyScans), scan.sequence, scan.entry.stamp});
}

}  // namespace

std::uint32_t nextNumber(const MissionState& state, FindSample::Kind kind) {
    std::uint32_t highest = 0;
    for (const Decision& decision : *state.decisions) {
        const auto* sample = std::get_if<FindSample>(&decision.content);
        if (sample != nullptr && sample->kind == kind) highest = std::max(highest, sample->number);
    }
    return highest + 1;
}

std::optional<FindKey> findNear(const MissionState& state, FindSample::Kind kind,
                                const Eigen::Vector3d& placeInMap, const std::string& tag, double reach) {
    std::optional<FindKey> nearest;
    for (const auto& [key, entry] : *state.finds) {
        if (key.first != kind || entry.victim.status == Status::Discarded) continue;
        if (!mayBeOne(kind, tag, entry.victim.tag)) continue;
        const double distance = (positionInMap(state, entry.victim) - placeInMap).norm();
        if (!(distance < reach)) continue;
        reach = distance;
        nearest = key;
    }
    return nearest;
}

bool isFiled(const MissionState& state, const CandidateSample& candidate) {
    // A find that was taken back is not in the state: then nobody has filed it.
    if (candidate.victim != 0 && state.finds->contains({candidate.kind, candidate.victim})) return true;
    const Eigen::Vector3d place = positionInMap(state, candidate);
    const std::string tag = tagOf(candidate);
    // A code between two victims names neither.
    const bool names = candidate.kind == FindSample::Kind::Code ||
                       (candidate.kind == FindSample::Kind::Victim &&
                        std::any_of(candidate.cues.begin(), candidate.cues.end(),
                                    [&](const Cue& cue) { return cue.kind == "tag" && cue.text == tag; }));
    return std::any_of(state.finds->begin(), state.finds->end(), [&](const auto& find) {
        const FindSample& there = find.second.victim;
        if (find.first.first != candidate.kind || !mayBeOne(candidate.kind, tag, there.tag)) return false;
        // A discarded find is none, but what lies beside it may be one.
        const bool none = there.status == Status::Discarded && there.mergedInto == 0;
        const bool named = !none && names && !tag.empty() && tag == there.tag;
        const double reach = none ? SameDiscarded : named ? SameNamed : SameFind;
        return (positionInMap(state, there) - place).norm() < reach;
    });
}

FindSample filed(const MissionState& state, FindSample::Kind kind, const FrozenEvidence& frozen,
                 const std::string& station, Time now) {
    if (const auto known = findNear(state, kind, frozen.positionInMap, frozen.tag)) {
        FindSample sample = *changed(state, *known, station, now);
        addSigns(sample, frozen);
        addEvidence(sample, frozen.evidence);
        return sample;
    }
    FindSample sample = fresh(state, kind, station, now);
    sample.found = frozen.found;
    sample.robot = frozen.robot;
    sample.autonomous = frozen.autonomous;
    sample.scan = frozen.scan;
    sample.positionInScan = frozen.positionInScan;
    sample.positionInMap = frozen.positionInMap;
    sample.deviation = frozen.deviation;
    if (state.info) sample.area = state.info->sample.area;
    addSigns(sample, frozen);
    addEvidence(sample, frozen.evidence);
    return sample;
}

std::string tagOf(const CandidateSample& candidate) {
    std::string other;
    for (const Cue& cue : candidate.cues) {
        if (cue.kind == "tag" && !cue.text.empty()) return cue.text;
        if (cue.kind == "code" || cue.kind == "hazard") fill(other, cue.text);
    }
    return other;
}

void addCues(FrozenEvidence& frozen, const CandidateSample& candidate) {
    fill(frozen.tag, tagOf(candidate));
    for (const Cue& cue : candidate.cues) {
        if (cue.kind == "heat" && std::isnan(frozen.heat)) frozen.heat = cue.value;
        if (cue.kind == "co2" && std::isnan(frozen.co2)) frozen.co2 = cue.value;
        if (cue.kind == "motion") frozen.motion = true;
        const char* kind = cue.kind == "heat"       ? "thermal"
                           : cue.kind == "co2"      ? "gas"
                           : cue.kind == "sighting" ? "sighting"
                                                    : "picture";
        if (!cue.topic.empty()) frozen.evidence.push_back({kind, cue.topic, cue.sequence, cue.stamp});
    }
}

Eigen::Vector3d aboveFloor(const Eigen::Vector3d& floorInMap, std::optional<double> height) {
    const bool kept = height && *height > floorInMap.z() && *height < floorInMap.z() + Storey;
    return {floorInMap.x(), floorInMap.y(), kept ? *height : floorInMap.z() + LyingHeight};
}

void hang(FrozenEvidence& frozen, const MissionState& state, std::uint64_t scan,
          const Eigen::Vector3d& inMap) {
    frozen.positionInMap = inMap;
    const auto known = state.keyScans->find(scan);
    if (known == state.keyScans->end()) return;
    frozen.scan = scan;
    frozen.positionInScan = known->second.pose.scanInMap.inverse() * inMap;
}

std::uint64_t scanBeside(const MissionState& state, const std::string& robot, const Eigen::Vector3d& inMap) {
    std::uint64_t newest = 0, nearest = 0, doubted = 0, othersDoubted = 0;
    double shortest = std::numeric_limits<double>::infinity(), ofNewest = shortest;
    for (const auto& [id, scan] : *state.keyScans) {
        const bool own = scan.entry.robot == robot;
        if (scan.pose.trust == ScanTrust::Uncertain) (own ? doubted : othersDoubted) = id;
        if (scan.pose.trust != ScanTrust::Certain) continue;
        const double distance = (scan.pose.scanInMap.translation() - inMap).norm();
        if (own) {
            newest = id;
            ofNewest = distance;
        }
        if (distance <= shortest) {
            shortest = distance;
            nearest = id;
        }
    }
    if (ofNewest < InSight) return newest;
    if (nearest != 0) return nearest;
    return doubted != 0 ? doubted : othersDoubted;
}

FindSample filedFrom(const MissionState& state, const CandidateSample& candidate, const std::string& station,
                     Time now, const FrozenEvidence& seen) {
    const auto known = state.candidates->find(candidate.id);
    const FirstReport first = known == state.candidates->end() ? FirstReport() : known->second.firstReport;
    FrozenEvidence frozen;
    frozen.found = seen.found == Time() ? now : seen.found;
    frozen.robot = candidate.cues.empty() ? seen.robot : candidate.cues.front().robot;
    if (!first.robot.empty()) frozen.robot = first.robot;
    frozen.scan = candidate.scan;
    frozen.positionInScan = candidate.positionInScan;
    frozen.positionInMap = positionInMap(state, candidate);
    frozen.deviation = candidate.deviation;
    addCues(frozen, candidate);
    if (std::isnan(frozen.heat)) frozen.heat = seen.heat;
    if (std::isnan(frozen.co2)) frozen.co2 = seen.co2;
    frozen.evidence.insert(frozen.evidence.end(), seen.evidence.begin(), seen.evidence.end());
    addScan(frozen, state);
    const auto robot = state.robots.find(frozen.robot);
    if (robot != state.robots.end() && robot->second->mode)
        frozen.autonomous = robot->second->mode->sample.autonomous;
    if (first.autonomous) frozen.autonomous = *first.autonomous;
    return filed(state, candidate.kind, frozen, station, now);
}

std::vector<CandidateSample> candidatesNear(const MissionState& state, FindSample::Kind kind,
                                            const Eigen::Vector3d& placeInMap) {
    std::vector<CandidateSample> near;
    for (const auto& [id, entry] : *state.candidates) {
        const CandidateSample& one = entry.candidate;
        if (one.kind != kind || one.dismissed || !(one.confidence >= LeastShownConfidence)) continue;
        if (one.victim != 0 && state.finds->contains({kind, one.victim})) continue;
        if ((positionInMap(state, one) - placeInMap).norm() < SameFind) near.push_back(one);
    }
    std::stable_sort(near.begin(), near.end(), [&](const CandidateSample& a, const CandidateSample& b) {
        return (positionInMap(state, a) - placeInMap).norm() < (positionInMap(state, b) - placeInMap).norm();
    });
    std::string tag;
    std::erase_if(near, [&](const CandidateSample& one) {
        const std::string ownTag = tagOf(one);
        if (!mayBeOne(kind, tag, ownTag)) return true;
        fill(tag, ownTag);
        return false;
    });
    return near;
}

CandidateSample filedAs(CandidateSample candidate, std::uint32_t number, const std::string& station,
                        Time now) {
    candidate.victim = number;
    candidate.station = station;
    candidate.stamp = std::max(now, candidate.stamp + std::chrono::nanoseconds(1));
    return candidate;
}

std::optional<FindSample> withStatus(const MissionState& state, const FindKey& find, Status status,
                                     const std::string& station, Time now) {
    auto sample = changed(state, find, station, now);
    if (!sample) return std::nullopt;
    sample->status = status;
    sample->mergedInto = 0;
    return sample;
}

std::optional<NearFind> nearestOfKind(const MissionState& state, const FindKey& find) {
    const FindSample* const one = leitstand::find(state, find);
    if (one == nullptr) return std::nullopt;
    const Eigen::Vector3d place = positionInMap(state, *one);
    std::optional<NearFind> nearest;
    for (const auto& [key, entry] : *state.finds) {
        const FindSample& other = entry.victim;
        if (key.first != find.first || key == find || other.status == Status::Discarded) continue;
        const double distance = (positionInMap(state, other) - place).norm();
        if (!nearest || distance < nearest->distance) nearest = NearFind{key, distance};
    }
    return nearest;
}

std::optional<FindSample> mergedInto(const MissionState& state, const FindKey& find, std::uint32_t into,
                                     const std::string& station, Time now) {
    auto sample = changed(state, find, station, now);
    const FindSample* target = leitstand::find(state, {find.first, into});
    if (!sample || target == nullptr || into == find.second || target->status == Status::Discarded)
        return std::nullopt;
    sample->status = Status::Discarded;
    sample->mergedInto = into;
    return sample;
}

std::optional<FindSample> movedTo(const MissionState& state, const FindKey& find,
                                  const Eigen::Vector3d& floorInMap, const std::string& station, Time now) {
    auto sample = changed(state, find, station, now);
    if (!sample || !floorInMap.allFinite()) return std::nullopt;
    sample->positionInMap = aboveFloor(floorInMap, positionInMap(state, *sample).z());
    const auto scan = state.keyScans->find(sample->scan);
    if (scan != state.keyScans->end())
        sample->positionInScan = scan->second.pose.scanInMap.inverse() * sample->positionInMap;
    sample->deviation = Unknown;  // a person has put it there
    return sample;
}

std::optional<FindSample> filledIn(const MissionState& state, const FindSample& form,
                                   const std::string& station, Time now) {
    auto sample = changed(state, {form.kind, form.number}, station, now);
    if (!sample) return std::nullopt;
    sample->form = form.form;
    sample->motion = form.motion;
    sample->heat = form.heat;
    sample->sound = form.sound;
    sample->co2 = form.co2;
    sample->situation = form.situation;
    sample->tag = form.tag;
    sample->area = form.area;
    sample->text = form.text;
    return sample;
}

FindSample withEdits(FindSample newest, const FindSample& before, const FindSample& after) {
    const auto isSame = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
    for (VictimSign FindSample::*sign :
         {&FindSample::form, &FindSample::motion, &FindSample::heat, &FindSample::sound, &FindSample::co2}) {
        const VictimSign &from = before.*sign, &to = after.*sign;
        if (from.state != to.state) (newest.*sign).state = to.state;
        if (from.text != to.text) (newest.*sign).text = to.text;
        if (!isSame(from.value, to.value)) (newest.*sign).value = to.value;
    }
    for (std::string FindSample::*words :
         {&FindSample::situation, &FindSample::tag, &FindSample::area, &FindSample::text}) {
        if (before.*words != after.*words) newest.*words = after.*words;
    }
    return newest;
}

std::optional<FindSample> wholeFind(const MissionState& state, const FindKey& find) {
    const FindSample* known = leitstand::find(state, find);
    if (known == nullptr) return std::nullopt;
    FindSample whole = *known;
    // Also what was merged into a find that was merged later.
    const auto partOf = [&](const FindSample* one) {
        for (std::size_t i = 0; one != nullptr && i <= state.finds->size(); ++i) {
            if (one->status != Status::Discarded || one->mergedInto == 0) return false;
            if (one->mergedInto == find.second) return true;
            one = leitstand::find(state, {find.first, one->mergedInto});
        }
        return false;
    };
    for (const auto& [key, entry] : *state.finds) {
        if (key.first == find.first && key != find && partOf(&entry.victim)) fill(whole, entry.victim);
    }
    return whole;
}

}  // namespace leitstand
