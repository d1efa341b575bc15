#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Returns the button for its name in a layout file: "a", "left_shoulder", "up" on a known pad; "button 7",
/// counted from 1, on any pad. Empty for other words.
[[nodiscard]] std::optional<PadControl> padButtonNamed(const std::string& name, PadLayout layout);

/// What a pad does while a window's layout is in use.
struct PadOverlay {
    PadBindings bindings;
    std::vector<std::string> refused;  ///< names of buttons that do not exist, or that drive or stop
};
/// Returns @p own with the commands of @p byButton (name of a button -> id of a command) on their buttons.
/// Buttons that drive or stop keep doing so.
[[nodiscard]] PadOverlay withCommands(const PadBindings& own,
                                      const std::map<std::string, std::string>& byButton);

}  // namespace leitstand
