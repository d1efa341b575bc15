#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/settings/map_sight.h"

namespace leitstand {

/// A place in the window: one pane, or parts side by side or one above the other.
struct PaneSplit {
    std::string pane = {};  ///< id, "camera"; empty: there are parts
    double share = 1.0;     ///< of the surrounding place, relative to the shares of its neighbours
    bool vertical = false;  ///< parts from top to bottom, not from left to right
    std::vector<PaneSplit> parts = {};  ///< two or more
};

/// Arrangement of the live window, and the meaning of keys and pad buttons (docs/design.md, "The window").
struct WindowLayout {
    std::string name = {};         ///< "drive"; from the file name: letters, digits, _ and -
    std::string title = {};        ///< for people
    PaneSplit panes = {};          ///< panes that are not listed are hidden
    std::string arrangement = {};  ///< window state after the operator moved panes (base64); overrides panes
    LayoutMap map = {};            ///< how the map is viewed; empty: stays as it is
    std::map<std::string, std::string> keys = {};  ///< command -> key, "Ctrl+K"; other commands keep theirs
    std::map<std::string, std::string> pad = {};  ///< button of the pad -> command; other buttons keep theirs
};

/// Returns the ids of all panes in @p split, from the upper left on.
[[nodiscard]] std::vector<std::string> panesIn(const PaneSplit& split);

}  // namespace leitstand
