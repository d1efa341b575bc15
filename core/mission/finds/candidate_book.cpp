#include "core/mission/finds/candidate_book.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include "core/base/time.h"
#include "core/mission/finds/behind.h"
#include "core/mission/finds/candidate.h"
#include "core/mission/finds/dismissal.h"
#include "core/mission/finds/ruled_out.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {
namespace {

using Kind = FindSample::Kind;

double flat(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return (a - b).head<2>().norm();
}

}  // namespace

struct CandidateBook::State {
    std::string station;
    CandidateSettings settings;
    TagPatterns patterns = usualTags();
    ScanPlaces scans;
    std::vector<CandidateThing> things;  ///< oldest first
    std::vector<CandidateThing> gone;    ///< published, then joined with an older one: publish again
    std::uint32_t newest = 0;
    std::uint64_t order = 0;
    bool changed = false;  ///< since dropSeenPast()

    [[nodiscard]] bool isSame(const CandidateThing& thing, const Eigen::Vector3d& inMap,
                              const Eigen::Matrix3d& covariance, const std::string& text) const;
    [[nodiscard]] CandidateThing* thingOf(const PlacedCue& cue);
    [[nodiscard]] CandidateThing* standsBefore(const PlacedCue& cue);
    void put(const PlacedCue& cue, CandidateThing& thing);
    void dropSeenPast();
    void dropRuledOut();
    void see(const PlacedCue& cue);
    void support(const PlacedCue& cue);
    void join(CandidateThing& thing);
    void forget();
    void forget(const Cue& sighting);
    [[nodiscard]] CandidateSample sampleOf(const CandidateThing& thing, Time now) const;
    [[nodiscard]] bool isDue(CandidateThing& thing, Time now);
};

CandidateBook::CandidateBook(std::string station, const CandidateSettings& settings)
    : m_state(std::make_unique<State>()) {
    m_state->station = std::move(station);
    m_state->settings = settings;
}
CandidateBook::~CandidateBook() = default;
CandidateBook::CandidateBook(CandidateBook&&) noexcept = default;
CandidateBook& CandidateBook::operator=(CandidateBook&&) noexcept = default;

bool CandidateBook::State::isSame(const CandidateThing& thing, const Eigen::Vector3d& inMap,
                                  const Eigen::Matrix3d& covariance, const std::string& text) const {
    const double away = flat(thing.inMap, inMap);
    if (thing.what == Kind::Code) return thing.text() == text && away < settings.sameCode;
    if (thing.what == Kind::Hazard) return thing.text() == text && away < settings.sameHazard;
    if (away < settings.sameVictim) return true;
    if (away > settings.widestGate) return false;
    return squaredDeviations(inMap - thing.inMap, thing.covariance + covariance) <
           settings.gate * settings.gate;
}

CandidateThing* CandidateBook::State::thingOf(const PlacedCue& cue) {
    CandidateThing* nearest = nullptr;
    const std::string tag = cue.cue.kind == "tag" ? cue.cue.text : std::string();
    for (CandidateThing& thing : things) {
        if (thing.what != cue.what) continue;
        // The same tag marks the same victim, another tag another victim.
        const std::string known = tag.empty() ? std::string() : thing.tag();
        const bool tagged = !tag.empty() && known == tag && flat(thing.inMap, cue.inMap) < settings.sameCode;
        if (!tagged && !known.empty()) continue;
        if (!tagged && !isSame(thing, cue.inMap, cue.covariance, cue.cue.text)) continue;
        if (!tagged && thing.what == Kind::Victim && thing.isRuledOut() &&
            !isOfRuledOut(cue, thing, settings))
            continue;
        if (nearest == nullptr || flat(thing.inMap, cue.inMap) < flat(nearest->inMap, cue.inMap))
            nearest = &thing;
    }
    return nearest;
}

/// Returns the published person past whom the camera saw @p cue, the nearest to the camera; null: none.
CandidateThing* CandidateBook::State::standsBefore(const PlacedCue& cue) {
    CandidateThing* nearest = nullptr;
    double least = 1.0;
    for (CandidateThing& thing : things) {
        if (thing.what != Kind::Victim || thing.id == 0 || thing.isRuledOut() || thing.withdrawn) continue;
        const auto share = sharePassing(cue.from, cue.inMap, thing.inMap, settings);
        if (!share || *share >= least) continue;
        least = *share;
        nearest = &thing;
    }
    return nearest;
}

void CandidateBook::State::put(const PlacedCue& cue, CandidateThing& thing) {
    thing.add(cue, scans);
    thing.settle(scans, settings);
}

/// Drops candidates that a sure person in front of them explains.
void CandidateBook::State::dropSeenPast() {
    if (!std::exchange(changed, false)) return;
    const auto isOf = [this](const CandidateThing& far) {
        return std::any_of(things.begin(), things.end(), [&](const CandidateThing& one) {
            const bool sure = one.id != 0 || one.confidence >= settings.publishFrom;
            return &one != &far && one.what == Kind::Victim && sure && !one.isRuledOut() && !one.withdrawn &&
                   isSeenPast(far, one, scans, settings);
        });
    };
    for (std::size_t i = 0; i < things.size();) {
        CandidateThing& far = things[i];
        // An unpublished candidate is dropped only when it would be published.
        const bool matters = far.id != 0 || far.confidence >= settings.publishFrom;
        if (!matters || far.what != Kind::Victim || far.victim != 0 || far.dismissed || !isOf(far)) {
            ++i;
            continue;
        }
        far.confidence = 0.0;  // taken back by us: it may come again
        if (far.id != 0 && !far.withdrawn) gone.push_back(far);
        things.erase(things.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

/// Drops unpublished candidates that are again a thing that a person ruled out.
void CandidateBook::State::dropRuledOut() {
    const auto isAgain = [this](const CandidateThing& made) {
        if (made.id != 0 || made.what != Kind::Victim || made.confidence < settings.publishFrom) return false;
        return std::any_of(things.begin(), things.end(), [&](const CandidateThing& thing) {
            return thing.what == Kind::Victim && thing.isRuledOut() && isRuledOutAgain(made, thing, settings);
        });
    };
    for (auto one = things.begin(); one != things.end();) one = isAgain(*one) ? things.erase(one) : one + 1;
}

void CandidateBook::State::support(const PlacedCue& cue) {
    // Only the candidate that it most likely belongs to: a lamp beside a victim does not breathe, nor does a
    // thing that was ruled out.
    CandidateThing* best = nullptr;
    double most = 0.0;
    for (CandidateThing& thing : things) {
        const double away = flat(thing.inMap, cue.inMap);
        if (thing.what != Kind::Victim || thing.isRuledOut() || away > cue.reach) continue;
        const double likely = thing.confidence / (0.5 + away);
        if (likely <= most) continue;
        most = likely;
        best = &thing;
    }
    if (best != nullptr) put(cue, *best);
}

void CandidateBook::State::join(CandidateThing& thing) {
    for (CandidateThing& other : things) {
        if (&other == &thing || other.what != thing.what || other.isRuledOut() != thing.isRuledOut())
            continue;
        // Only when their middles are near: the gate alone would chain a row of things together.
        if (flat(other.inMap, thing.inMap) > settings.sameVictim) continue;
        if (!isSame(other, thing.inMap, thing.covariance, thing.text())) continue;
        const std::string tag = thing.tag(), others = other.tag();
        if (!tag.empty() && !others.empty() && tag != others) continue;
        CandidateThing& older = other.order < thing.order ? other : thing;
        CandidateThing& younger = other.order < thing.order ? thing : other;
        if (younger.victim != 0) continue;  // the operator has two of them
        for (auto& [key, look] : younger.looks) {
            CandidateLook& into = older.looks[key];
            if (look.cues > into.cues) into = look;
        }
        older.settle(scans, settings);
        if (younger.id != 0) gone.push_back(younger);
        things.erase(things.begin() + (&younger - things.data()));
        return;  // references moved; the rest joins with the next cue
    }
}

void CandidateBook::State::forget() {
    if (things.size() <= settings.most) return;
    const auto least = std::min_element(things.begin(), things.end(), [](const auto& a, const auto& b) {
        const auto rank = [](const CandidateThing& one) { return one.id != 0 ? 2.0 : one.confidence; };
        return rank(a) < rank(b);
    });
    if (least->id == 0) things.erase(least);
}

/// Removes what the robot reported earlier of the same thing.
void CandidateBook::State::forget(const Cue& sighting) {
    for (CandidateThing& thing : things) {
        std::erase_if(thing.looks, [&](const auto& look) {
            return std::get<0>(look.first) == sighting.kind && std::get<1>(look.first) == sighting.robot &&
                   std::get<3>(look.first) == sighting.text;
        });
        thing.settle(scans, settings);
    }
    std::erase_if(things, [](const CandidateThing& thing) { return thing.id == 0 && thing.looks.empty(); });
}

void CandidateBook::add(const PlacedCue& cue) {
    State& state = *m_state;
    if (!cue.inMap.allFinite() || !cue.covariance.allFinite()) return;
    state.changed = true;
    if (cue.reach > 0.0) return state.support(cue);
    if (cue.cue.kind == "sighting") state.forget(cue.cue);
    if (cue.cue.kind == "code" && isVictimTag(cue.cue.text, state.patterns)) {
        // The tag marks a victim even when nothing else is seen of it.
        PlacedCue tag = cue;
        tag.cue.kind = "tag";
        tag.what = Kind::Victim;
        state.see(tag);
    } else if (cue.cue.kind == "code") {
        // A code on a victim is evidence of the victim, and still a code of its own.
        for (CandidateThing& thing : state.things) {
            if (thing.what != Kind::Victim || (thing.inMap - cue.inMap).norm() > state.settings.codeNear)
                continue;
            state.put(cue, thing);
        }
    }
    state.see(cue);
}

/// Adds @p cue to the thing that it belongs to, or makes one.
void CandidateBook::State::see(const PlacedCue& cue) {
    CandidateThing* thing = thingOf(cue);
    const bool past = cue.what == Kind::Victim && cue.cue.kind != "tag";
    if (past && (thing == nullptr || thing->id == 0)) {
        if (CandidateThing* nearer = standsBefore(cue)) {
            PlacedCue moved = cue;
            moved.inMap = cue.from + *sharePassing(cue.from, cue.inMap, nearer->inMap, settings) *
                                         (cue.inMap - cue.from);
            return put(moved, *nearer);
        }
    }
    if (thing == nullptr) {
        CandidateThing made;
        made.what = cue.what;
        made.order = ++order;
        things.push_back(std::move(made));
        thing = &things.back();
    }
    put(cue, *thing);
    join(*thing);
    forget();
}

void CandidateBook::tags(TagPatterns patterns) {
    m_state->patterns = std::move(patterns);
}

void CandidateBook::discarded(FindSample::Kind kind, std::uint32_t number, bool discarded) {
    for (CandidateThing& thing : m_state->things) {
        if (number != 0 && thing.what == kind && thing.victim == number) thing.discarded = discarded;
    }
}

void CandidateBook::scanAt(std::uint64_t id, const Pose& scanInMap) {
    State& state = *m_state;
    const auto known = state.scans.find(id);
    const bool moved = known != state.scans.end() && !known->second.isApprox(scanInMap, 1e-9);
    state.scans[id] = scanInMap;
    if (!moved) return;
    state.changed = true;
    for (CandidateThing& thing : state.things) {
        const bool seen = std::any_of(thing.looks.begin(), thing.looks.end(),
                                      [&](const auto& look) { return std::get<2>(look.first) == id; });
        if (seen) thing.settle(state.scans, state.settings);
    }
}

void CandidateBook::take(const CandidateSample& sample) {
    State& state = *m_state;
    state.changed = true;
    state.newest = std::max(state.newest, sample.id);
    for (CandidateThing& thing : state.things) {
        if (thing.id != sample.id) continue;
        const bool byPerson = sample.victim != 0 || isDismissal(sample, state.settings);
        if (sample.station == state.station && sample.stamp <= thing.last.stamp) {
            // Our own, unless a person's decision crossed our last sample: the decision stands.
            if (sample.stamp == thing.last.stamp || !byPerson) return;
        } else {
            thing.last.victim = sample.victim;
            thing.last.dismissed = sample.dismissed;
        }
        if (thing.victim != sample.victim) thing.discarded = false;
        thing.victim = sample.victim;
        thing.dismissed = isDismissal(sample, state.settings);
        return;
    }
    // Taken back by a book, not by a person: it may come again.
    if (sample.dismissed && !isDismissal(sample, state.settings)) return;
    CandidateThing thing;
    thing.id = sample.id;
    thing.what = sample.kind;
    thing.order = ++state.order;
    thing.victim = sample.victim;
    thing.dismissed = sample.dismissed;
    thing.last = sample;
    thing.published = sample.stamp;
    for (const Cue& cue : sample.cues) {
        PlacedCue placed;
        placed.cue = cue;
        placed.what = sample.kind;
        placed.scan = sample.scan;
        const auto scan = state.scans.find(sample.scan);
        placed.inMap =
            scan == state.scans.end() ? sample.positionInMap : scan->second * sample.positionInScan;
        const double deviation = std::isfinite(sample.deviation) ? sample.deviation : 0.3;
        placed.covariance = std::max(1e-4, deviation * deviation) * Eigen::Matrix3d::Identity();
        // As sure as it was then.
        for (int i = 0; i < state.settings.moments; ++i) {
            thing.add(placed, state.scans);
            placed.cue.stamp += std::chrono::seconds(1);
        }
    }
    if (thing.looks.empty() || !sample.positionInMap.allFinite()) return;
    thing.inMap = sample.positionInMap;
    thing.settle(state.scans, state.settings);
    thing.last.positionInMap = thing.inMap;
    thing.last.confidence = thing.confidence;
    state.things.push_back(std::move(thing));
}

CandidateSample CandidateBook::State::sampleOf(const CandidateThing& thing, Time now) const {
    CandidateSample sample;
    sample.stamp = now;
    sample.station = station;
    sample.id = thing.id;
    sample.kind = thing.what;
    const auto scan = scans.find(thing.scan);
    sample.scan = scan == scans.end() ? 0 : thing.scan;
    sample.positionInMap = thing.inMap;
    sample.positionInScan =
        scan == scans.end() ? Eigen::Vector3d::Zero() : Eigen::Vector3d(scan->second.inverse() * thing.inMap);
    sample.deviation = thing.deviation();
    sample.confidence = thing.confidence;
    sample.victim = thing.victim;
    sample.dismissed = thing.dismissed || thing.withdrawn;
    sample.cues = thing.cues();
    return sample;
}

bool CandidateBook::State::isDue(CandidateThing& thing, Time now) {
    if (thing.id == 0) {
        if (thing.confidence < settings.publishFrom) return false;
        thing.id = ++newest;
        return true;
    }
    // Publish again when our last sample crossed the operator's decision.
    if (thing.victim != thing.last.victim) return true;
    if (thing.dismissed) return !thing.last.dismissed;
    const bool before = thing.withdrawn;
    if (thing.victim == 0 && thing.confidence < settings.drop) thing.withdrawn = true;
    if (thing.confidence >= settings.publishFrom) thing.withdrawn = false;
    if (toSeconds(now - thing.published) < settings.interval) {
        thing.withdrawn = before;
        return false;
    }
    return before != thing.withdrawn || (thing.inMap - thing.last.positionInMap).norm() > settings.move ||
           std::abs(thing.confidence - thing.last.confidence) > settings.change ||
           thing.cues().size() != thing.last.cues.size();
}

std::vector<CandidateSample> CandidateBook::due(Time now) {
    State& state = *m_state;
    state.dropSeenPast();
    state.dropRuledOut();
    std::vector<CandidateSample> samples;
    for (CandidateThing& thing : std::exchange(state.gone, {})) {
        thing.dismissed = true;
        CandidateSample last = state.sampleOf(thing, now);
        last.cues.clear();  // its cues belong to the older one now
        samples.push_back(std::move(last));
    }
    for (CandidateThing& thing : state.things) {
        if (!state.isDue(thing, now)) continue;
        thing.last = state.sampleOf(thing, now);
        if (thing.dismissed) thing.last = judged(thing.last, true, state.station, now, state.settings);
        thing.published = now;
        samples.push_back(thing.last);
    }
    return samples;
}

}  // namespace leitstand
