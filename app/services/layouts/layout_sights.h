#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/settings/window_layout.h"

namespace leitstand {

/// Keeps the view of the map in each layout: first as the layout defines it, then as the operator last had it
/// there. If a layout defines no view, the previous view is kept.
class LayoutSights {
public:
    /// @p own: the operator's view, used for everything that layouts leave open.
    explicit LayoutSights(const MapSight& own) : m_own(own) {}

    /// Returns the view for @p layout, which is now used. @p now: the present view, which is kept for the
    /// previous layout.
    [[nodiscard]] MapSight enter(const WindowLayout& layout, const MapSight& now);
    /// Makes the layout @p name use the view in its file when it is next used.
    void forget(const std::string& name);
    /// Returns the operator's own view, while @p now is shown.
    [[nodiscard]] MapSight own(const MapSight& now) const;

private:
    /// The layout to which the present view belongs. Its name is empty before the first layout.
    struct Holder {
        std::string name = {};
        LayoutMap ofLayout = {};
    };

    MapSight m_own;
    std::optional<Holder> m_holder = Holder{};  ///< empty: the present view belongs to no layout
    std::map<std::string, MapSight> m_kept;     ///< by layout
};

}  // namespace leitstand
