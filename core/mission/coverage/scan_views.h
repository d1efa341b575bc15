#pragma once

#include <cstddef>
#include <vector>

#include "core/mission/coverage/search_view.h"

namespace leitstand {

/// How little views differ that are one.
struct ViewGrain {
    double apart = 0.0;   ///< nearer than this [m] ...
    double turned = 0.0;  ///< ... and turned by less [rad]
};

/// The views that hang on one scan, without those that add nothing to others. The grain may only become
/// coarser: what little is lost then is the edge of what others see.
class ScanViews {
public:
    explicit ScanViews(const ViewGrain& grain) : m_grain(grain) {}

    /// Whether @p view is one with a view that is known.
    [[nodiscard]] bool holds(const SearchView& view) const { return holds(m_views, view); }
    void add(const SearchView& view) { m_views.push_back(view); }
    /// Of views that are one by @p grain the first is kept. Nothing where the grain is as coarse already.
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
