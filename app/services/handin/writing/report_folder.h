#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace leitstand {

/// Returns the folder to which the hand-in of @p mission is written repeatedly; empty: none.
[[nodiscard]] std::filesystem::path reportFolderOf(const std::filesystem::path& mission);

/// Stores @p out as that folder, beside the mission's log, so that a station that resumes the mission
/// continues to write there. If @p out is empty, removes what is stored. Error when it cannot be written.
[[nodiscard]] Result<void> keepReportFolder(const std::filesystem::path& mission,
                                            const std::filesystem::path& out);

}  // namespace leitstand
