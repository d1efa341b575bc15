#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/settings/map_sight.h"

namespace leitstand {

/// A place in the window: one pane, or parts side by side or one above the other.
struct PaneSplit {
    std::string pane = {};              ///< id, "camera"; empty: there are parts
    double share = 1.0;                 ///< of the room of the place around it, beside its neighbours' shares
    bool vertical = false;              ///< parts from top to bottom, not from left to right
    std::vector<PaneSplit> parts = {};  ///< two or more
};

/// How the live window is arranged, and which keys and pad buttons mean what (design, section 7).
struct WindowLayout {
    std::string name = {};         ///< "drive"; the file's, letters, digits, _ and -
    std::string title = {};        ///< for people
    PaneSplit panes = {};          ///< panes that are not named are hidden
    std::string arrangement = {};  ///< as the operator moved them (base64, of the window); goes before panes
    LayoutMap map = {};            ///< how the map is looked at; says nothing: stays as it is
    std::map<std::string, std::string> keys = {};  ///< by command: "Ctrl+K"; others have their own
    std::map<std::string, std::string> pad = {};   ///< by button of the pad: command; others have their own
};

/// The ids of all panes in @p split, from the upper left on.
[[nodiscard]] std::vector<std::string> panesIn(const PaneSplit& split);

}  // namespace leitstand
