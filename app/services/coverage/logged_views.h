#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "app/services/log/event_decoder.h"
#include "core/base/progress.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/coverage/search_view.h"

namespace leitstand {

/// Where the cameras of a recorded mission looked from.
struct LoggedViews {
    std::vector<SearchView> views;  ///< attached to the mission's key scans; nearly equal views are one
    std::size_t leftOut = 0;        ///< how often a new view did not fit into SearchBook
};

/// Finds the views in the log @p bag, and follows all decisions on the map and their undos. When cancelled,
/// returns what was found so far.
[[nodiscard]] LoggedViews loggedViews(BagReader& bag, EventDecoder& decoder, const Progress& progress = {});

/// Finds the views in the mission @p folder, whose robots are those of robotsOf(); none when it cannot be
/// read.
[[nodiscard]] LoggedViews loggedViews(const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace leitstand
