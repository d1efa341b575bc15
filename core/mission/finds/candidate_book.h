#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mission/finds/placed_cue.h"
#include "core/mission/finds/victim_tags.h"

namespace leitstand {

struct CandidateSample;

/// Settings that decide when cues belong to one thing and when a thing is published.
struct CandidateSettings {
    double sameVictim = 0.75;  ///< parts of one body lie within this distance, seen from above [m]
    double sameCode = 1.2;     ///< codes with the same text within this distance are one code [m]
    double sameHazard = 0.5;   ///< placards with the same name within this distance are one placard [m]
    double gate = 3.0;  ///< parts of one body may also lie within this number of standard deviations ...
    double widestGate = 1.2;  ///< ... but never farther apart than this [m]
    double body = 0.12;  ///< standard deviation of the distance between a seen part and the body's middle [m]
    /// A thing belongs to a person if its ray passes the person within this, from above [m] ...
    double beside = 0.35;
    double behind = 0.5;        ///< ... and it seems to be at least this far behind the person [m] ...
    double above = 0.6;         ///< ... and the ray passes at most this far above or below the person [m]
    double publishFrom = 0.57;  ///< least confidence at which a candidate is published
    double drop = 0.35;         ///< confidence below which a published candidate is withdrawn
    int moments = 6;            ///< a kind of cue has full weight after this many half seconds with cues
    double breathFrom = 0.5;    ///< nearby CO2 has full weight if heat or motion gives this confidence
    double interval = 1.0;      ///< least time between updates of a candidate [s]
    double move = 0.03;         ///< an update is published if the position changed by this [m] ...
    double change = 0.04;       ///< ... or the confidence changed by this
    double codeNear = 0.5;      ///< a code within this distance of a victim belongs to it [m]
    double tagged = 0.6;        ///< confidence if only the tag of a victim was seen
    int tagMoments = 3;         ///< a tag has full weight after it was read in this many half seconds
    /// A cue within this distance of a thing that was ruled out belongs to it [m] ...
    double ruledOut = 0.35;
    double ruledOutGate = 2.0;  ///< ... or within this many standard deviations
    /// Largest number of things; beyond it the least certain unpublished one is dropped.
    std::size_t most = 500;
};

/// Combines cues over time, views, robots and kinds into candidates. Deterministic: the same calls make the
/// same candidates. Positions belong to the key scans from which the cues were seen, and move with them. One
/// thread.
///
/// The confidence of a victim's candidate is 1 - product(1 - weight) over its kinds of cues. These are heat
/// (by how much it looks like a person), motion, nearby CO2, a code on it and its tag. A robot's own sighting
/// is made from the same heat and is never added to it.
class CandidateBook {
public:
    explicit CandidateBook(std::string station, const CandidateSettings& settings = {});
    ~CandidateBook();
    CandidateBook(CandidateBook&&) noexcept;
    CandidateBook& operator=(CandidateBook&&) noexcept;

    void add(const PlacedCue& cue);
    /// Sets the pose of the key scan @p id.
    void scanAt(std::uint64_t id, const Pose& scanInMap);
    /// Takes a candidate that an earlier session, another station or the operator published. Later candidates
    /// get higher numbers. A candidate that was dismissed or filed as a victim remains so.
    void take(const CandidateSample& sample);
    /// Sets which codes are tags of victims.
    void tags(TagPatterns patterns);
    /// Sets whether the find @p number of @p kind is discarded, for all candidates that were filed as this
    /// find. A thing beside a discarded find may still be a find.
    void discarded(FindSample::Kind kind, std::uint32_t number, bool discarded);
    /// Returns the candidates that are new or changed, each at most once per @ref
    /// CandidateSettings::interval.
    [[nodiscard]] std::vector<CandidateSample> due(Time now);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
