#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace leitstand {

/// Into which folder the hand-in of @p mission is written again and again; empty: into none.
[[nodiscard]] std::filesystem::path reportFolderOf(const std::filesystem::path& mission);

/// Keeps that folder beside the mission's log, so that a station that resumes it goes on; @p out empty: it
/// ends. An error when it cannot be written.
[[nodiscard]] Result<void> keepReportFolder(const std::filesystem::path& mission,
                                            const std::filesystem::path& out);

}  // namespace leitstand
