#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// The button that a layout file names: "a", "left_shoulder", "up" of a known pad; "button 7", counted from
/// 1, of any. Nothing for other words.
[[nodiscard]] std::optional<PadControl> padButtonNamed(const std::string& name, PadLayout layout);

/// What a pad does while a window's layout is in use.
struct PadOverlay {
    PadBindings bindings;
    std::vector<std::string> refused;  ///< buttons that are none, or that drive or stop
};
/// @p own, with the commands of @p byButton (names of buttons, ids of commands) on their buttons. Driving and
/// STOP stay where the operator has them.
[[nodiscard]] PadOverlay withCommands(const PadBindings& own,
                                      const std::map<std::string, std::string>& byButton);

}  // namespace leitstand
