#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/mission/finds/placed_cue.h"
#include "core/mission/finds/victim_tags.h"

namespace leitstand {

/// When cues are of one thing, and when a thing is told.
struct CandidateSettings {
    double sameVictim = 0.75;   ///< parts of one body are within, from above [m]
    double sameCode = 1.2;      ///< codes of one text [m]
    double sameHazard = 0.5;    ///< placards of one name [m]
    double gate = 3.0;          ///< ... or within so many deviations
    double widestGate = 1.2;    ///< ... but never farther [m]
    double body = 0.12;         ///< deviation by which part of a body is seen [m]
    double beside = 0.35;       ///< what is seen so near past a person, from above, is of that person [m] ...
    double behind = 0.5;        ///< ... though it seems to be so far behind, or farther [m] ...
    double above = 0.6;         ///< ... where the ray passes it no higher or lower than this [m]
    double tell = 0.57;         ///< confidence from which a candidate is told
    double drop = 0.35;         ///< ... below which one that was told is taken back
    int moments = 6;            ///< half seconds in which cues of one kind came until they count in full
    double breathFrom = 0.5;    ///< sureness by heat or motion from which CO2 near by agrees in full
    double interval = 1.0;      ///< between updates of a candidate, at least [s]
    double move = 0.03;         ///< a change worth an update [m]
    double change = 0.04;       ///< ... of the confidence
    double codeNear = 0.5;      ///< a code so near to a victim is on it, or beside it [m]
    double tagged = 0.6;        ///< how sure the tag of a victim alone makes that it lies there
    int tagMoments = 3;         ///< half seconds in which a tag was read until it counts in full
    double ruledOut = 0.35;     ///< of what a person ruled out, what is so near is that thing [m] ...
    double ruledOutGate = 2.0;  ///< ... or within so many deviations
    std::size_t most = 500;     ///< candidates; beyond, the least sure that was not told goes
};

/// Joins cues over time, views, robots and kinds into candidates. Deterministic: the same calls make the same
/// candidates. Positions hang on the key scans from which the cues were seen and move with them. One thread.
///
/// A candidate of a victim is as sure as its kinds of cues agree: each has a weight after what it tells (heat
/// by how much it looks like a person, motion, CO2 near by, a code on it, its tag), and 1 - product(1 -
/// weight) is the confidence. A robot's own sighting comes of the same heat and never adds to it.
class CandidateBook {
public:
    explicit CandidateBook(std::string station, const CandidateSettings& settings = {});
    ~CandidateBook();
    CandidateBook(CandidateBook&&) noexcept;
    CandidateBook& operator=(CandidateBook&&) noexcept;

    void add(const PlacedCue& cue);
    /// Where the key scan @p id is now.
    void scanAt(std::uint64_t id, const Pose& scanInMap);
    /// What somebody said of a candidate: an earlier session, another station, the operator. Numbers go on
    /// above it; what was dismissed or filed as a victim stays so.
    void take(const CandidateSample& sample);
    /// What codes say that are tags of victims.
    void tags(TagPatterns patterns);
    /// Whether the find that candidates were filed as, of that kind and number, is none: what lies beside it
    /// may be.
    void discarded(VictimSample::Kind kind, std::uint32_t number, bool discarded);
    /// Candidates that are new or changed, at most each @ref CandidateSettings::interval.
    [[nodiscard]] std::vector<CandidateSample> due(Time now);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
