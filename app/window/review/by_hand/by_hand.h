#pragma once

#include <filesystem>

#include <QString>

namespace leitstand {

/// Result of correcting a map by hand.
struct ByHandOutcome {
    bool decided = false;  ///< whether decisions were added
    QString text;          ///< text for the operator; empty: nothing to report
};

/// Opens the map of @p mission in a separate window. Returns when the window is closed and all decisions are
/// in the mission. Nobody may have the mission open for writing during this time.
[[nodiscard]] ByHandOutcome correctByHand(const std::filesystem::path& mission);

}  // namespace leitstand
