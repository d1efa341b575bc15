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
    int number = 0;      ///< 0 is the one on which the map begins, 1 the next above
    double floor = 0.0;  ///< median height of its floor in the map [m]
};

/// Returns the storeys of @p map, from the lowest on. A storey is a height at which many scans were taken.
/// Storeys are 1.8 m or more apart, with few scans between them, so that ramps and stairs are no storeys.
/// Uncertain scans do not count. Empty: no scan counts.
[[nodiscard]] std::vector<Storey> storeysOf(const Map& map);
/// Returns the storeys of @p scans, which all count.
[[nodiscard]] std::vector<Storey> storeysOf(std::span<const ReportScan> scans);
/// Returns the name of the storey @p number: "0", "+1", "−1".
[[nodiscard]] std::string storeyName(int number);

/// The heights of the map that a storey covers, with the ramps that lead up from it [m].
struct StoreyHeights {
    double from = -std::numeric_limits<double>::infinity();
    std::optional<double> to = {};  ///< empty: all that is above

    /// Returns whether height @p z of the map [m] belongs to the storey.
    [[nodiscard]] bool hold(double z) const { return z >= from && (!to || z < *to); }
    bool operator==(const StoreyHeights&) const = default;
};

/// Returns the heights of the storey at @p index in @p storeys.
[[nodiscard]] StoreyHeights heightsOf(const std::vector<Storey>& storeys, std::size_t index);

/// A storey, and the heights of the map that belong to it.
struct StoreyShare {
    int number = 0;
    StoreyHeights heights = {};
};

/// Returns all heights of a map, divided among @p storeys. The lowest one also has everything below it.
/// Without storeys: a single share that has everything.
[[nodiscard]] std::vector<StoreyShare> sharesOf(const std::vector<Storey>& storeys);
/// Returns the index in @p shares of the share that has height @p z [m]. There must be at least one share.
[[nodiscard]] std::size_t shareAt(std::span<const StoreyShare> shares, double z);

}  // namespace leitstand
