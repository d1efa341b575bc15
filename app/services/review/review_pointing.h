#pragma once

#include <filesystem>
#include <string>

#include "app/services/finds/freezing.h"
#include "app/services/recorded/review_index.h"
#include "app/services/review/review_scene.h"
#include "core/base/result.h"
#include "core/mission/finds/find_book.h"

namespace leitstand {

/// Returns the evidence of a find that a reviewer files by pointing at @p at in a picture of @p robot;
/// otherwise as evidenceAt(). Its place is the one that a live station would have found from the scans of the
/// seconds before. If the log of @p mission has only whole turns of the scanners, the newest of these are
/// used. Takes some tenths of a second, since it reads the log. Error when the log cannot be read, the robot
/// was not in the map, or nothing was scanned there.
[[nodiscard]] Result<FrozenEvidence> evidenceIn(const std::filesystem::path& mission,
                                                const ReviewIndex& index, const ReviewMoment& moment,
                                                const std::string& robot, const MissionState& shown,
                                                const PicturePoint& at);

}  // namespace leitstand
