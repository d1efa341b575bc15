#pragma once

#include <filesystem>

#include <QString>

namespace leitstand {

/// Outcome of merging two maps.
struct MergingOutcome {
    std::filesystem::path mission;  ///< the new one; empty: there is none
    QString text;                   ///< outcome in words
};

/// Returns the folder beside @p mission for its map merged with that of @p other: "monday+tuesday". A number
/// is appended when that exists.
[[nodiscard]] std::filesystem::path mergedName(const std::filesystem::path& mission,
                                               const std::filesystem::path& other);

/// Merges the maps of @p mission and @p other into a new mission, mergedName(), and tidies it. A window shows
/// the progress and can cancel it. Both missions stay as they are.
[[nodiscard]] MergingOutcome mergeInFront(const std::filesystem::path& mission,
                                          const std::filesystem::path& other);

}  // namespace leitstand
