#pragma once

#include <string>

#include <Eigen/Core>

#include "app/services/review/review_scene.h"
#include "core/mission/finds/find_book.h"

namespace leitstand {

/// Returns the evidence of a find that a reviewer files by pointing at @p placeInMap [m] at @p moment. The
/// find counts as found at that moment by @p robot, in its mode and with its pictures of then. It is attached
/// to the key scan that shows the place. @p shown: the state whose map was pointed at.
[[nodiscard]] FrozenEvidence evidenceAt(const ReviewMoment& moment, const std::string& robot,
                                        const MissionState& shown, const Eigen::Vector3d& placeInMap);

}  // namespace leitstand
