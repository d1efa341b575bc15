#pragma once

#include <string>

#include "core/mapping/map.h"
#include "core/mapping/relaxation/closed_map.h"

namespace leitstand::cli {

/// The result of `register` as JSON, laid out as design section 6 says; @p loops: of --close-loops, else
/// null.
[[nodiscard]] std::string registerJson(const Map& map, const ClosedMap* loops, double seconds);

/// The result of `register` as a table for people.
[[nodiscard]] std::string registerTable(const Map& map, const ClosedMap* loops, double seconds);

}  // namespace leitstand::cli
