#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/mission/finds/candidate.h"

namespace leitstand {

// A person hides what is behind. What a camera sees warm or moving in a person's direction belongs to that
// person. The scanner may show only the wall behind, because a waving arm was elsewhere when it scanned.

/// Returns the share of the way from the camera at @p from to @p to at which it passes @p body, seen from
/// above. It passes beside the body by less than CandidateSettings::beside and ends more than
/// CandidateSettings::behind behind it. Empty: it does not pass the body, or the camera's place is unknown
/// (NaN).
[[nodiscard]] std::optional<double> sharePassing(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                 const Eigen::Vector3d& body,
                                                 const CandidateSettings& settings);

/// Whether nearly all evidence of @p far was seen past @p nearer. Then @p far is a part of that.
[[nodiscard]] bool isSeenPast(const CandidateThing& far, const CandidateThing& nearer,
                              const ScanPlaces& scans, const CandidateSettings& settings);

}  // namespace leitstand
