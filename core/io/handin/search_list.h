#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// What a kind of sensor saw of the floor, or a piece that it missed.
struct ListedSearch {
    std::string sensor;              ///< "scanner", "camera", "infrared"
    std::string what;                ///< "reachable", "seen", "missed"
    double area = 0.0;               ///< [m2]
    double share = 0.0;              ///< of the floor that can be reached, 0 to 1
    double x = 0.0, y = 0.0;         ///< of a missed piece, in the map [m]; else 0
    std::optional<int> storey = {};  ///< number of the one that it is told of; empty: all
};

/// A table "sensor,what,m2,percent,x,y" with a row for each; places of missed pieces have centimetres. Where
/// any row is told of a storey, another column "storey" follows.
[[nodiscard]] Result<void> writeSearchList(const std::filesystem::path& file,
                                           const std::vector<ListedSearch>& rows);
/// Reads such a table. Errors name file, line and expectation.
[[nodiscard]] Result<std::vector<ListedSearch>> readSearchList(const std::filesystem::path& file);

}  // namespace leitstand
