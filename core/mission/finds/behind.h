#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/mission/finds/candidate.h"

namespace leitstand {

// A person hides what is behind. What a camera sees warm or moving in a person's direction is of that person,
// though the scanner, which saw the place while a waving arm was elsewhere, has only the wall behind there.

/// How much of the way from the camera at @p from to @p to lies before it passes @p body, as a share, seen
/// from above: beside it by less than CandidateSettings::beside, and ending more than
/// CandidateSettings::behind behind. Empty: it does not pass it, or nobody knows where the camera was (NaN).
[[nodiscard]] std::optional<double> sharePassing(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                 const Eigen::Vector3d& body,
                                                 const CandidateSettings& settings);

/// Whether nearly all that told of @p far came past @p nearer: then it is a part of that.
[[nodiscard]] bool isSeenPast(const CandidateThing& far, const CandidateThing& nearer,
                              const ScanPlaces& scans, const CandidateSettings& settings);

}  // namespace leitstand
