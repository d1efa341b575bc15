#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/event/event.h"

namespace leitstand {

/// A map that was made after the mission, as a station would have published it.
struct MadeMap {
    /// For each key scan an event when it was complete, then one for its pose; by sequence.
    std::vector<Event> events;
    std::vector<std::string> warnings;
};

/// Registers the clouds of @p mission (mapOffline()). Each event has the sequence of the bag's event after
/// which it belongs. Problems become warnings. When cancelled, returns what was registered so far.
[[nodiscard]] MadeMap madeMapOf(const std::filesystem::path& mission, const Progress& progress);

}  // namespace leitstand
