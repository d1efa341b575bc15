#pragma once

#include <string>

#include "core/mapping/map.h"
#include "core/mapping/relaxation/closed_map.h"

namespace leitstand::cli {

/// Returns the result of `register` as JSON, in the layout of docs/design.md, "Command lines". @p loops: the
/// result of --close-loops; null without it. @p seconds: total time [s].
[[nodiscard]] std::string registerJson(const Map& map, const ClosedMap* loops, double seconds);

/// Returns the result of `register` as a table for people.
[[nodiscard]] std::string registerTable(const Map& map, const ClosedMap* loops, double seconds);

}  // namespace leitstand::cli
