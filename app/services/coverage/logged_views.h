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
    std::vector<SearchView> views;  ///< hung on the mission's key scans; those that hardly differ are one
    std::size_t leftOut = 0;        ///< as of SearchBook
};

/// Follows the log with all that was decided and taken back. Cancelled: what was found so far.
[[nodiscard]] LoggedViews loggedViews(BagReader& bag, EventDecoder& decoder, const Progress& progress = {});

/// Likewise of the mission @p folder with the robots that it keeps; none where it cannot be read.
[[nodiscard]] LoggedViews loggedViews(const std::filesystem::path& folder, const Progress& progress = {});

}  // namespace leitstand
