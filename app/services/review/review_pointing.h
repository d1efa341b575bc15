#pragma once

#include <filesystem>
#include <string>

#include "app/services/finds/freezing.h"
#include "app/services/recorded/review_index.h"
#include "app/services/review/review_scene.h"
#include "core/base/result.h"
#include "core/mission/finds/find_book.h"

namespace leitstand {

/// Returns the evidence of a find that a reviewer files by pointing at @p at in a picture of @p robot. It is
/// as of evidenceAt(), at the place that a live station would have found by what the robot's scanners saw in
/// the seconds before. When the log of @p mission has whole turns only, it uses the newest of them. Reads the
/// log, which takes some tenths of a second. Error when the log cannot be read, or nothing was scanned there.
[[nodiscard]] Result<FrozenEvidence> evidenceIn(const std::filesystem::path& mission,
                                                const ReviewIndex& index, const ReviewMoment& moment,
                                                const std::string& robot, const MissionState& shown,
                                                const PicturePoint& at);

}  // namespace leitstand
