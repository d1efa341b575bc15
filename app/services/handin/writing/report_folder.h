#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace leitstand {

/// Returns the folder into which the hand-in of @p mission is written repeatedly; empty: none.
[[nodiscard]] std::filesystem::path reportFolderOf(const std::filesystem::path& mission);

/// Stores that folder beside the mission's log, so that a station that resumes it continues; empty @p out
/// ends it. Error when it cannot be written.
[[nodiscard]] Result<void> keepReportFolder(const std::filesystem::path& mission,
                                            const std::filesystem::path& out);

}  // namespace leitstand
