#pragma once

#include <optional>
#include <vector>

#include "core/mapping/map.h"

namespace leitstand {

/// A level on which robots drove.
struct Storey {
    int number = 0;      ///< 0 is the one on which the map begins, 1 the next above
    double floor = 0.0;  ///< median height of its floor in the map [m]
};

/// The storeys of @p map, from the lowest on: heights at which many scans were taken, 1.8 m or more apart,
/// and few between them, so that ramps and stairs are none of their own. Empty: no scan counts.
[[nodiscard]] std::vector<Storey> storeysOf(const Map& map);

/// Heights of the map between which a storey lies, with the ramps that lead up from it [m].
struct StoreyHeights {
    double from = 0.0;
    std::optional<double> to;  ///< empty: all that is above

    bool operator==(const StoreyHeights&) const = default;
};

/// Of the @p index -th of @p storeys.
[[nodiscard]] StoreyHeights heightsOf(const std::vector<Storey>& storeys, std::size_t index);

}  // namespace leitstand
