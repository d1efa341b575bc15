#pragma once

#include <filesystem>

#include <QString>

namespace leitstand {

/// Result of merging two maps.
struct MergingOutcome {
    std::filesystem::path mission;  ///< the new mission; empty: there is none
    QString text;                   ///< result in words
};

/// Returns the folder for the map of @p mission merged with that of @p other: "monday+tuesday", beside
/// @p mission. Appends a number if that folder exists: "monday+tuesday-2".
[[nodiscard]] std::filesystem::path mergedName(const std::filesystem::path& mission,
                                               const std::filesystem::path& other);

/// Merges the maps of @p mission and @p other into a new mission in the folder mergedName(). Tidies the new
/// map if the two could be joined; otherwise they are side by side in it. A window shows the progress and can
/// cancel it. The two missions are not changed.
[[nodiscard]] MergingOutcome mergeInFront(const std::filesystem::path& mission,
                                          const std::filesystem::path& other);

}  // namespace leitstand
