#pragma once

#include <filesystem>

#include <QString>

namespace leitstand {

/// What came of merging.
struct MergingOutcome {
    std::filesystem::path mission;  ///< the new one; empty: there is none
    QString text;                   ///< in words
};

/// The folder beside @p mission in which its map is merged with that of @p other: "monday+tuesday", or with a
/// number behind it where that is there.
[[nodiscard]] std::filesystem::path mergedName(const std::filesystem::path& mission,
                                               const std::filesystem::path& other);

/// Brings the maps of @p mission and @p other into a new mission, mergedName(), and tidies it, in front of a
/// window that tells how far it is and cancels it. Both stay as they are.
[[nodiscard]] MergingOutcome mergeInFront(const std::filesystem::path& mission,
                                          const std::filesystem::path& other);

}  // namespace leitstand
