#pragma once

#include <filesystem>
#include <string>

#include "app/services/finds/freezing.h"
#include "app/services/recorded/review_index.h"
#include "app/services/review/review_scene.h"
#include "core/base/result.h"
#include "core/mission/finds/find_book.h"

namespace leitstand {

/// What a reviewer who points to @p at in a picture of @p robot files: as evidenceAt(), at the place that a
/// station would have told live, by what the robot's scanners saw in the seconds before; where the log of
/// @p mission has whole turns only, by the newest of them. Reads the log: some tenths of a second. Errors:
/// the log cannot be read, or nothing was scanned there.
[[nodiscard]] Result<FrozenEvidence> evidenceIn(const std::filesystem::path& mission,
                                                const ReviewIndex& index, const ReviewMoment& moment,
                                                const std::string& robot, const MissionState& shown,
                                                const PicturePoint& at);

}  // namespace leitstand
