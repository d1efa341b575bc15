#include "core/mission/coverage/scan_views.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leitstand {

bool ScanViews::holds(const std::vector<SearchView>& known, const SearchView& view) const {
    return std::any_of(known.begin(), known.end(), [&](const SearchView& other) {
        return other.sensor == view.sensor &&
               distanceBetween(other.cameraInScan, view.cameraInScan) < m_grain.apart &&
               angleBetween(other.cameraInScan, view.cameraInScan) < m_grain.turned &&
               std::abs(other.field.pixelsPerRadian - view.field.pixelsPerRadian) <
                   0.01 * other.field.pixelsPerRadian;
    });
}

void ScanViews::thin(const ViewGrain& grain) {
    if (!(grain.apart > m_grain.apart)) return;
    m_grain = grain;
    std::vector<SearchView> kept;
    for (const SearchView& view : m_views) {
        if (!holds(kept, view)) kept.push_back(view);
    }
    m_views = std::move(kept);
}

}  // namespace leitstand
