#pragma once

#include <string>

#include "core/mapping/map.h"

namespace leitstand::cli {

/// The result of `register` as JSON, laid out as design section 6 says.
[[nodiscard]] std::string registerJson(const Map& map, double seconds);

/// The result of `register` as a table for people.
[[nodiscard]] std::string registerTable(const Map& map, double seconds);

}  // namespace leitstand::cli
