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

/// Thresholds for when cues belong to one thing and when a thing is published.
struct CandidateSettings {
    double sameVictim = 0.75;  ///< parts of one body lie within this, seen from above [m]
    double sameCode = 1.2;     ///< codes with the same text are one within this [m]
    double sameHazard = 0.5;   ///< placards with the same name are one within this [m]
    double gate = 3.0;         ///< parts of one body may also lie within this many standard deviations
    double widestGate = 1.2;   ///< but never farther than this [m]
    double body = 0.12;        ///< standard deviation of a seen part from the body's middle [m]
    double beside = 0.35;  ///< what is seen past a person is of the person: within this, from above [m] ...
    double behind = 0.5;   ///< ... when it seems at least this far behind the person [m] ...
    double above = 0.6;    ///< ... and its ray passes the person no higher or lower than this [m]
    double publishFrom = 0.57;  ///< confidence from which a candidate is published
    double drop = 0.35;         ///< confidence below which a published candidate is taken back
    int moments = 6;            ///< half seconds with cues of one kind that make the kind count in full
    double breathFrom = 0.5;    ///< confidence by heat or motion from which CO2 near by counts in full
    double interval = 1.0;      ///< least time between updates of a candidate [s]
    double move = 0.03;         ///< change of position worth an update [m]
    double change = 0.04;       ///< change of confidence worth an update
    double codeNear = 0.5;      ///< a code within this of a victim belongs to it [m]
    double tagged = 0.6;        ///< confidence by the tag of a victim alone
    int tagMoments = 3;         ///< half seconds with a tag read that make it count in full
    double ruledOut = 0.35;     ///< a cue within this of a ruled-out thing is of that thing [m] ...
    double ruledOutGate = 2.0;  ///< ... or within this many standard deviations
    std::size_t most = 500;     ///< candidates; beyond this the least sure unpublished one is dropped
};

/// Joins cues over time, views, robots and kinds into candidates. Deterministic: the same calls make the same
/// candidates. Positions hang on the key scans from which the cues were seen and move with them. One thread.
///
/// The confidence of a victim's candidate is 1 - product(1 - weight) over its kinds of cues. These are heat
/// (by how much it looks like a person), motion, CO2 near by, a code on it and its tag. A robot's own
/// sighting comes from the same heat and never adds to it.
class CandidateBook {
public:
    explicit CandidateBook(std::string station, const CandidateSettings& settings = {});
    ~CandidateBook();
    CandidateBook(CandidateBook&&) noexcept;
    CandidateBook& operator=(CandidateBook&&) noexcept;

    void add(const PlacedCue& cue);
    /// Sets the pose of the key scan @p id.
    void scanAt(std::uint64_t id, const Pose& scanInMap);
    /// Takes over a candidate that an earlier session, another station or the operator published. New
    /// candidates get numbers above its number. A candidate that was dismissed or filed as a victim stays so.
    void take(const CandidateSample& sample);
    /// Sets the patterns of codes that are tags of victims.
    void tags(TagPatterns patterns);
    /// Sets whether find @p number of @p kind is discarded, for all candidates that were filed as it. A thing
    /// beside a discarded find may still be a find.
    void discarded(FindSample::Kind kind, std::uint32_t number, bool discarded);
    /// Returns the candidates that are new or changed, each at most once per @ref
    /// CandidateSettings::interval.
    [[nodiscard]] std::vector<CandidateSample> due(Time now);

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
