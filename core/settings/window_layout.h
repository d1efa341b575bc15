#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/settings/map_sight.h"

namespace leitstand {

/// An area of the window: one pane, or parts side by side or one above the other.
struct PaneSplit {
    std::string pane = {};  ///< id of the pane, "camera"; empty: there are parts
    double share = 1.0;     ///< share of the surrounding area, relative to the shares of its neighbours
    bool vertical = false;  ///< whether parts go from top to bottom; otherwise from left to right
    std::vector<PaneSplit> parts = {};  ///< at least two parts
};

/// Arrangement of the live window, and which commands keys and pad buttons have (docs/design.md, "The
/// window").
struct WindowLayout {
    std::string name = {};   ///< "drive"; the name of the file: letters, digits, _ and -
    std::string title = {};  ///< name for people
    PaneSplit panes = {};    ///< panes in the window; all others are hidden
    /// State of the window after the operator moved panes (base64); replaces `panes`.
    std::string arrangement = {};
    LayoutMap map = {};  ///< how the map is viewed; empty values do not change
    /// Command -> key, "Ctrl+K"; other commands keep their keys.
    std::map<std::string, std::string> keys = {};
    /// Button of the pad -> command; other buttons keep their commands.
    std::map<std::string, std::string> pad = {};
};

/// Returns the ids of all panes in @p split, beginning at the upper left.
[[nodiscard]] std::vector<std::string> panesIn(const PaneSplit& split);

}  // namespace leitstand
