#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// How much of the floor one kind of sensor has seen, or a piece of floor that it has missed.
struct ListedSearch {
    std::string sensor;              ///< "scanner", "camera", "infrared"
    std::string what;                ///< "reachable", "seen", "missed"
    double area = 0.0;               ///< [m2]
    double share = 0.0;              ///< share of the reachable floor, 0 to 1
    double x = 0.0, y = 0.0;         ///< where a missed piece is in the map [m]; 0 in other rows
    std::optional<int> storey = {};  ///< number of the storey; empty: all storeys
};

/// Writes a table "sensor,what,m2,percent,x,y" with a line for each of @p rows. Only missed pieces have
/// coordinates, with two decimals. If any row has a storey, a column "storey" follows.
[[nodiscard]] Result<void> writeSearchList(const std::filesystem::path& file,
                                           const std::vector<ListedSearch>& rows);
/// Reads a table of writeSearchList(), with or without the column "storey". Errors name file, line and
/// expectation.
[[nodiscard]] Result<std::vector<ListedSearch>> readSearchList(const std::filesystem::path& file);

}  // namespace leitstand
