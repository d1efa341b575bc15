#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/services/log/event_decoder.h"
#include "core/base/progress.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/coverage/search_view.h"

namespace leitstand {

/// From where the cameras of a recorded mission looked.
struct LoggedViews {
    /// Attached to the mission's key scans; nearly equal views are listed once.
    std::vector<SearchView> views;
    std::size_t leftOut = 0;  ///< number of new views for which SearchBook had no space
};

/// Finds the views in the log @p bag. Follows all decisions about the map, and their undos. When cancelled,
/// returns what was found so far.
[[nodiscard]] LoggedViews loggedViews(BagReader& bag, EventDecoder& decoder, const Progress& progress = {});

/// Finds the views in the mission @p folder, with the robots of robotsOf(). None when it cannot be read.
[[nodiscard]] LoggedViews loggedViews(const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace leitstand
