#pragma once

#include <filesystem>
#include <vector>

#include "app/session/log/event_decoder.h"
#include "core/base/progress.h"
#include "core/io/bag/bag_reader.h"
#include "core/mission/coverage/search_view.h"

namespace leitstand {

/// Where the cameras of a recorded mission looked from, hung on its key scans; views that hardly differ are
/// one. Cancelled: what was found so far.
[[nodiscard]] std::vector<SearchView> loggedViews(BagReader& bag, EventDecoder& decoder,
                                                  const Progress& progress = {});

/// Likewise of the mission @p folder with the robots that it keeps; none where it cannot be read.
[[nodiscard]] std::vector<SearchView> loggedViews(const std::filesystem::path& folder,
                                                  const Progress& progress = {});

}  // namespace leitstand
