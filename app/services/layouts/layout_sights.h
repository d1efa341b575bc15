#pragma once

#include <map>
#include <optional>
#include <string>

#include "core/settings/window_layout.h"

namespace leitstand {

/// How the map is looked at in each layout: at first as the layout says, then as the operator last had it
/// there. A layout that says nothing leaves the map to the one before it.
class LayoutSights {
public:
    /// @p own: the operator's, of which layouts take what they leave out.
    explicit LayoutSights(const MapSight& own) : m_own(own) {}

    /// What to show in @p layout. @p now: what is shown until then, which the layout before it keeps.
    [[nodiscard]] MapSight enter(const WindowLayout& layout, const MapSight& now);
    /// @p name is what its file says again, when it is entered.
    void forget(const std::string& name);
    /// The operator's own, while @p now is shown.
    [[nodiscard]] MapSight own(const MapSight& now) const;

private:
    /// The layout that the map is looked at for; its name is empty before there was one.
    struct Holder {
        std::string name = {};
        LayoutMap says = {};
    };

    MapSight m_own;
    std::optional<Holder> m_holder = Holder{};  ///< none: what is shown is nobody's
    std::map<std::string, MapSight> m_kept;     ///< by layout
};

}  // namespace leitstand
