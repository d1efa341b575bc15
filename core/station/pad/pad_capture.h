#pragma once

#include <optional>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Finds which control the operator pushes, on any joystick. It is the first button that is pressed, or the
/// axis that is pushed furthest from its value at the beginning. Pure.
class PadCapture {
public:
    /// @p rest: the pad while nobody touches it. Buttons that are held then are ignored until they are
    /// released.
    explicit PadCapture(PadState rest);

    /// Returns the control when it is pushed far enough; empty before that.
    [[nodiscard]] std::optional<PadControl> update(const PadState& now);

private:
    PadState m_rest;
};

}  // namespace leitstand
