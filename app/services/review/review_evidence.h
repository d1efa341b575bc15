#pragma once

#include <string>

#include <Eigen/Core>

#include "app/services/review/review_scene.h"
#include "core/mission/finds/find_book.h"

namespace leitstand {

/// Returns the evidence of a find that a reviewer files by pointing at @p placeInMap [m] at @p moment. The
/// find was made by @p robot at that moment, with the robot's mode and pictures of that moment. It is
/// attached to the key scan that shows the place. @p shown: state whose map the reviewer pointed at.
[[nodiscard]] FrozenEvidence evidenceAt(const ReviewMoment& moment, const std::string& robot,
                                        const MissionState& shown, const Eigen::Vector3d& placeInMap);

}  // namespace leitstand
