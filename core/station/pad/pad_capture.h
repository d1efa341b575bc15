#pragma once

#include <optional>

#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Finds out which control the operator pushes, on any joystick: of buttons the first that comes down, of
/// axes the one that is pushed furthest from where it was at the beginning. Pure.
class PadCapture {
public:
    /// @p rest: the pad while nobody touches it. Buttons held then count only once they were let go.
    explicit PadCapture(PadState rest);

    /// The control once it is pushed well.
    [[nodiscard]] std::optional<PadControl> update(const PadState& now);

private:
    PadState m_rest;
};

}  // namespace leitstand
