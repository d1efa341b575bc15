#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Returns the button that a layout file names: "a", "left_shoulder", "up" of a known pad; "button 7",
/// counted from 1, of any. Empty for other words.
[[nodiscard]] std::optional<PadControl> padButtonNamed(const std::string& name, PadLayout layout);

/// What a pad does while a window's layout is in use.
struct PadOverlay {
    PadBindings bindings;
    std::vector<std::string> refused;  ///< buttons that do not exist, or that drive or stop
};
/// Returns @p own with the commands of @p byButton (names of buttons, ids of commands) on their buttons.
/// Driving and STOP stay where the operator has them.
[[nodiscard]] PadOverlay withCommands(const PadBindings& own,
                                      const std::map<std::string, std::string>& byButton);

}  // namespace leitstand
