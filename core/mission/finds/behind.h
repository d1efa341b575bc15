#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/mission/finds/candidate.h"

namespace leitstand {

// A person hides what is behind. So warmth or motion that a camera sees in the direction of a person belongs
// to that person. The scanner may show only the wall behind, because a waving arm was elsewhere when it
// scanned.

/// Returns where the ray from the camera at @p from to @p to passes @p body: as a share of the ray's length,
/// seen from above. It passes if it misses the body by at most CandidateSettings::beside, and by at most
/// CandidateSettings::above in height. It must also end at least CandidateSettings::behind behind the body.
/// Empty: the ray does not pass, or @p from is unknown (NaN).
[[nodiscard]] std::optional<double> sharePassing(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                                 const Eigen::Vector3d& body,
                                                 const CandidateSettings& settings);

/// Whether nearly all evidence of @p far was seen in passing @p nearer. If so, @p far belongs to @p nearer.
[[nodiscard]] bool isSeenPast(const CandidateThing& far, const CandidateThing& nearer,
                              const ScanPlaces& scans, const CandidateSettings& settings);

}  // namespace leitstand
