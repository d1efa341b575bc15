#pragma once

#include <vector>

#include <QString>

#include "widgets/models/pad/pad_texts.h"

namespace leitstand {

/// One physical control of a gamepad: a stick with all its directions, a trigger, or a button.
struct PadSpot {
    bool isButton = true;
    int index = 0;  ///< of the button, or of the stick's first axis
    friend bool operator==(const PadSpot&, const PadSpot&) = default;
};

/// What a spot of a pad does.
struct PadCallout {
    PadSpot spot;
    QString control;    ///< "Left trigger", "Left stick"
    QString does;       ///< "Drive, turn"; empty: nothing
    bool stop = false;  ///< it stops all robots
    bool held = false;  ///< right now
};

/// Callouts left and right of the drawing of a known pad, each from the top.
struct PadCallouts {
    std::vector<PadCallout> left, right;
};
[[nodiscard]] PadCallouts padCallouts(const PadBindings& bindings,
                                      const std::vector<PadCommandFace>& commands, const PadState& state);

/// Returns a callout for every control that does something, for any joystick.
[[nodiscard]] std::vector<PadCallout> padList(const PadBindings& bindings,
                                              const std::vector<PadCommandFace>& commands,
                                              const PadState& state);

}  // namespace leitstand
