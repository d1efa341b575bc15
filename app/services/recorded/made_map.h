#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/event/event.h"

namespace leitstand {

/// A map that was made after the mission, said as a station would have.
struct MadeMap {
    std::vector<Event> events;  ///< each key scan when it was complete, then its pose; by sequence
    std::vector<std::string> warnings;
};

/// Registers the clouds of @p mission (mapOffline()). Events have the sequence of the bag's event that they
/// come after. What is wrong is a warning; cancelled: what was registered so far.
[[nodiscard]] MadeMap madeMapOf(const std::filesystem::path& mission, const Progress& progress);

}  // namespace leitstand
