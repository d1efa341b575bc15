#pragma once

#include <filesystem>

#include <QString>

namespace leitstand {

/// What came of deciding on a map by hand.
struct ByHandOutcome {
    bool decided = false;  ///< something is decided that was not
    QString text;          ///< in words, where there is something to be told
};

/// Opens the map of @p mission in a window of its own and returns once that is closed and all of it is in the
/// mission. Nobody may have it open for writing meanwhile.
[[nodiscard]] ByHandOutcome correctByHand(const std::filesystem::path& mission);

}  // namespace leitstand
