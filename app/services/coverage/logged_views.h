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
    std::size_t leftOut = 0;        ///< as of SearchBook
};

/// Finds views in the log, with all decisions and undos. When cancelled, returns what was found so far.
[[nodiscard]] LoggedViews loggedViews(BagReader& bag, EventDecoder& decoder, const Progress& progress = {});

/// Finds views in the mission @p folder with the robots that it keeps; none when it cannot be read.
[[nodiscard]] LoggedViews loggedViews(const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace leitstand
