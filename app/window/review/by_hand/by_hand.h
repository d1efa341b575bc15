#pragma once

#include <filesystem>

#include <QString>

namespace leitstand {

/// Outcome of deciding on a map by hand.
struct ByHandOutcome {
    bool decided = false;  ///< decisions were added
    QString text;          ///< for the operator; empty: nothing to report
};

/// Opens the map of @p mission in a window of its own. Returns once the window is closed and all decisions
/// are in the mission. Nobody may have the mission open for writing meanwhile.
[[nodiscard]] ByHandOutcome correctByHand(const std::filesystem::path& mission);

}  // namespace leitstand
