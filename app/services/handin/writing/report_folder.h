#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace leitstand {

/// Returns the folder into which the hand-in of @p mission is written repeatedly; empty: none.
[[nodiscard]] std::filesystem::path reportFolderOf(const std::filesystem::path& mission);

/// Stores @p out as that folder, beside the mission's log: a station that resumes the mission goes on writing
/// there. An empty @p out removes what is stored. Error when it cannot be written.
[[nodiscard]] Result<void> keepReportFolder(const std::filesystem::path& mission,
                                            const std::filesystem::path& out);

}  // namespace leitstand
