#pragma once

#include <cstddef>
#include <vector>

#include "core/mission/coverage/search_view.h"

namespace leitstand {

/// Thresholds below which two views count as the same view.
struct ViewGrain {
    double apart = 0.0;   ///< distance between their cameras [m]
    double turned = 0.0;  ///< angle between their cameras [rad]
};

/// The views that belong to one scan, without near duplicates. The thresholds (grain) can only become
/// coarser. A duplicate that is dropped would have added only a little floor, at the edge of what the kept
/// views see.
class ScanViews {
public:
    explicit ScanViews(const ViewGrain& grain) : m_grain(grain) {}

    /// Whether a kept view counts as the same as @p view.
    [[nodiscard]] bool holds(const SearchView& view) const { return holds(m_views, view); }
    void add(const SearchView& view) { m_views.push_back(view); }
    /// Coarsens the grain to @p grain and keeps only the first of the views that are now the same. Does
    /// nothing when the grain is already as coarse.
    void thin(const ViewGrain& grain);

    [[nodiscard]] const ViewGrain& grain() const { return m_grain; }
    [[nodiscard]] const std::vector<SearchView>& views() const { return m_views; }
    [[nodiscard]] std::size_t size() const { return m_views.size(); }

private:
    [[nodiscard]] bool holds(const std::vector<SearchView>& known, const SearchView& view) const;

    ViewGrain m_grain;
    std::vector<SearchView> m_views;
};

}  // namespace leitstand
