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

/// The storeys of @p map, from the lowest on: heights at which many scans were taken, 1.8 m or more apart,
/// and few between them, so that ramps and stairs are none of their own. Empty: no scan counts.
[[nodiscard]] std::vector<Storey> storeysOf(const Map& map);
/// Likewise, of scans that all count.
[[nodiscard]] std::vector<Storey> storeysOf(std::span<const ReportScan> scans);
/// What the storey of this number is called: "0", "+1", "−1".
[[nodiscard]] std::string storeyName(int number);

/// Heights of the map between which a storey lies, with the ramps that lead up from it [m].
struct StoreyHeights {
    double from = -std::numeric_limits<double>::infinity();
    std::optional<double> to = {};  ///< empty: all that is above

    /// Whether height @p z of the map is among them [m].
    [[nodiscard]] bool hold(double z) const { return z >= from && (!to || z < *to); }
    bool operator==(const StoreyHeights&) const = default;
};

/// Of the @p index -th of @p storeys.
[[nodiscard]] StoreyHeights heightsOf(const std::vector<Storey>& storeys, std::size_t index);

/// A storey, and what of the map's heights counts to it.
struct StoreyShare {
    int number = 0;
    StoreyHeights heights = {};
};

/// All heights of a map, shared among @p storeys from the lowest on, which has all that is below it, too. Of
/// no storey: one that has everything.
[[nodiscard]] std::vector<StoreyShare> sharesOf(const std::vector<Storey>& storeys);
/// Which of @p shares, not empty, has height @p z [m].
[[nodiscard]] std::size_t shareAt(std::span<const StoreyShare> shares, double z);

}  // namespace leitstand
