#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Returns the button that a layout file calls @p name: "a", "left_shoulder", "up" on a known pad; "button
/// 7", counted from 1, on any pad. Empty for other names.
[[nodiscard]] std::optional<PadControl> padButtonNamed(const std::string& name, PadLayout layout);

/// What a pad does while a window's layout is in use.
struct PadOverlay {
    PadBindings bindings;
    /// Names of buttons that do not exist, or that drive or stop and keep doing so.
    std::vector<std::string> refused;
};
/// Returns @p own with the commands in @p byButton bound to their buttons (name of a button -> id of a
/// command). Buttons that drive or stop are not changed.
[[nodiscard]] PadOverlay withCommands(const PadBindings& own,
                                      const std::map<std::string, std::string>& byButton);

}  // namespace leitstand
