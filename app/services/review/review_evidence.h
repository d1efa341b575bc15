#pragma once

#include <string>

#include <Eigen/Core>

#include "app/services/review/review_scene.h"
#include "core/mission/finds/find_book.h"

namespace leitstand {

/// What a reviewer who points to @p placeInMap [m] at @p moment files: there, found then by @p robot as it
/// drove then, with its pictures of that moment as evidence, on the key scan that shows the place.
/// @p shown: the mission whose map was pointed to.
[[nodiscard]] FrozenEvidence evidenceAt(const ReviewMoment& moment, const std::string& robot,
                                        const MissionState& shown, const Eigen::Vector3d& placeInMap);

}  // namespace leitstand
