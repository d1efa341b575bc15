#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/mission/finds/candidate_book.h"

namespace leitstand {

using ScanPlaces = std::map<std::uint64_t, Pose>;  ///< key scans in the map

/// What was seen of one thing from about one place: cues of a kind of a robot from a key scan, as one.
struct CandidateLook {
    Eigen::Vector3d inScan = Eigen::Vector3d::Zero();  ///< weighted mean, in the key scan's frame [m]
    Eigen::Vector3d fromInScan =
        Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());  ///< camera, likewise; NaN: none
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of a usual one of them, likewise [m2]
    double weight = 0.0;                                       ///< sum of the cues' weights
    double evidence = 0.0;                                     ///< sum of confidence
    double strongest = 0.0;                                    ///< confidence
    int cues = 0;
    int moments = 0;  ///< in which they came: those of one half second are one
    Time moment{};    ///< newest
    Cue best;         ///< the surest, with the stamp and sequence of that one
};

/// One thing that was seen.
struct CandidateThing {
    using Key =
        std::tuple<std::string, std::string, std::uint64_t, std::string>;  ///< kind, robot, scan, text

    std::uint32_t id = 0;  ///< 0: not told yet
    VictimSample::Kind what = VictimSample::Kind::Victim;
    std::map<Key, CandidateLook> looks;
    std::uint32_t victim = 0;
    bool dismissed = false;  ///< by whoever; it stays so
    bool withdrawn = false;  ///< told, and not believed any more
    bool discarded = false;  ///< filed, and the find was discarded
    std::uint64_t order = 0;
    // as told last
    Time told{};
    CandidateSample last;
    // as it is now
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
    double confidence = 0.0;
    std::uint64_t scan = 0;  ///< that most of it was seen from

    void add(const PlacedCue& cue, const ScanPlaces& scans);
    /// Position, covariance and confidence anew.
    void settle(const ScanPlaces& scans, const CandidateSettings& settings);
    /// What its cues of it say most often; empty for victims without a tag.
    [[nodiscard]] std::string text() const;
    /// What the tag of a victim says that was read most; empty: none was.
    [[nodiscard]] std::string tag() const;
    /// A person has seen that it is none.
    [[nodiscard]] bool isRuledOut() const { return dismissed || discarded; }
    [[nodiscard]] std::vector<Cue> cues() const;
    [[nodiscard]] double deviation() const;
};

/// How many squared deviations of @p covariance @p off is long, seen from above; infinite where it has none.
[[nodiscard]] double squaredDeviations(const Eigen::Vector3d& off, const Eigen::Matrix3d& covariance);

/// How sure @p thing is, by kinds of cues.
[[nodiscard]] double confidenceOf(const CandidateThing& thing, const CandidateSettings& settings);

}  // namespace leitstand
