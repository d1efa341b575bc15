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

using ScanPlaces = std::map<std::uint64_t, Pose>;  ///< poses of key scans in the map, by id

/// Summary of the cues of one kind that one robot saw of one thing from one key scan.
struct CandidateLook {
    /// Weighted mean position, in the key scan's frame [m].
    Eigen::Vector3d inScan = Eigen::Vector3d::Zero();
    /// Mean position of the camera, same frame [m]; NaN: unknown.
    Eigen::Vector3d fromInScan = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
    /// Mean covariance of a cue, in the same frame [m2].
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
    double weight = 0.0;     ///< sum of the cues' weights
    double evidence = 0.0;   ///< sum of the cues' confidences
    double strongest = 0.0;  ///< highest confidence of a cue
    int cues = 0;
    int moments = 0;  ///< number of moments with cues; cues within half a second are one moment
    Time moment{};    ///< newest of these moments
    Cue best;         ///< the most certain cue, with its own stamp and sequence
};

/// A thing of which cues were seen.
struct CandidateThing {
    using Key =
        std::tuple<std::string, std::string, std::uint64_t, std::string>;  ///< kind, robot, scan, text

    std::uint32_t id = 0;  ///< 0: not published yet
    FindSample::Kind what = FindSample::Kind::Victim;
    std::map<Key, CandidateLook> looks;
    std::uint32_t victim = 0;
    bool dismissed = false;  ///< whether a person dismissed it; new cues do not change that
    bool withdrawn = false;  ///< whether it was published, and is no longer believed
    bool discarded = false;  ///< whether it was filed, and its find was discarded
    std::uint64_t order = 0;
    // as last published
    Time published{};
    CandidateSample last;
    // as it is now
    Eigen::Vector3d inMap = Eigen::Vector3d::Zero();
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();
    double confidence = 0.0;
    std::uint64_t scan = 0;  ///< key scan from which most of it was seen

    void add(const PlacedCue& cue, const ScanPlaces& scans);
    /// Computes position, covariance and confidence from all looks.
    void settle(const ScanPlaces& scans, const CandidateSettings& settings);
    /// Returns the text with the most evidence among the cues; empty: no cue has a text. Robots' own
    /// sightings are ignored.
    [[nodiscard]] std::string text() const;
    /// Returns the text of the victim tag with the most evidence; empty: no tag was read.
    [[nodiscard]] std::string tag() const;
    /// Whether a person dismissed it or discarded its find.
    [[nodiscard]] bool isRuledOut() const { return dismissed || discarded; }
    [[nodiscard]] std::vector<Cue> cues() const;
    [[nodiscard]] double deviation() const;
};

/// Returns the squared Mahalanobis distance of the offset @p off [m] for @p covariance, seen from above (x
/// and y). Infinite when @p covariance is degenerate.
[[nodiscard]] double squaredDeviations(const Eigen::Vector3d& off, const Eigen::Matrix3d& covariance);

/// Returns the confidence of @p thing, computed from its kinds of cues.
[[nodiscard]] double confidenceOf(const CandidateThing& thing, const CandidateSettings& settings);

}  // namespace leitstand
