#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mapping/map.h"
#include "core/mapping/report_scan.h"

namespace leitstand {

/// A level on which robots drove.
struct Storey {
    int number = 0;      ///< 0 is the storey on which the map begins, 1 the next one above
    double floor = 0.0;  ///< median height of its floor in the map [m]
};

/// Returns the storeys of @p map, from the lowest to the highest. A storey is a height at which many scans
/// were taken. Storeys are at least 1.8 m apart with few scans between them, so ramps and stairs are no
/// storeys. Uncertain scans are ignored. Empty: there are no certain scans.
[[nodiscard]] std::vector<Storey> storeysOf(const Map& map);
/// Returns the storeys of @p scans; all of them are used.
[[nodiscard]] std::vector<Storey> storeysOf(std::span<const ReportScan> scans);
/// Returns the name of the storey @p number: "0", "+1", "−1".
[[nodiscard]] std::string storeyName(int number);

/// The range of heights of the map that belongs to a storey, including the ramps that lead up from it [m].
struct StoreyHeights {
    double from = -std::numeric_limits<double>::infinity();
    std::optional<double> to = {};  ///< upper end; empty: everything above

    /// Returns whether the height @p z in the map [m] belongs to the storey.
    [[nodiscard]] bool hold(double z) const { return z >= from && (!to || z < *to); }
    bool operator==(const StoreyHeights&) const = default;
};

/// Returns the heights of the storey with index @p index in @p storeys.
[[nodiscard]] StoreyHeights heightsOf(const std::vector<Storey>& storeys, std::size_t index);

/// A storey, and the heights of the map that belong to it.
struct StoreyShare {
    int number = 0;
    StoreyHeights heights = {};
};

/// Divides all heights of a map among @p storeys. The lowest storey also gets everything below it. Without
/// storeys there is a single share with all heights.
[[nodiscard]] std::vector<StoreyShare> sharesOf(const std::vector<Storey>& storeys);
/// Returns the index of the one of @p shares that has the height @p z [m]. There must be at least one share.
[[nodiscard]] std::size_t shareAt(std::span<const StoreyShare> shares, double z);

}  // namespace leitstand
