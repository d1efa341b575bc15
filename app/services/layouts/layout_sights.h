#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/settings/window_layout.h"

namespace leitstand {

/// Keeps the view of the map in each layout: at first as the layout defines it, then as the operator last had
/// it there. A layout that defines no view keeps the one before it.
class LayoutSights {
public:
    /// @p own: the operator's view, used for what layouts leave out.
    explicit LayoutSights(const MapSight& own) : m_own(own) {}

    /// Returns the view for @p layout, which is entered. @p now: the present view, which is kept for the
    /// layout that is left.
    [[nodiscard]] MapSight enter(const WindowLayout& layout, const MapSight& now);
    /// Makes the layout @p name use the view of its file again when it is entered next.
    void forget(const std::string& name);
    /// Returns the operator's own view, while @p now is shown.
    [[nodiscard]] MapSight own(const MapSight& now) const;

private:
    /// The layout that the current view belongs to; its name is empty before the first one.
    struct Holder {
        std::string name = {};
        LayoutMap ofLayout = {};
    };

    MapSight m_own;
    std::optional<Holder> m_holder = Holder{};  ///< none: the current view belongs to no layout
    std::map<std::string, MapSight> m_kept;     ///< by layout
};

}  // namespace leitstand
