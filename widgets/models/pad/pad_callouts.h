#pragma once

#include <vector>

#include <QString>

#include "widgets/models/pad/pad_texts.h"

namespace leitstand {

/// A physical control of a gamepad: a stick with all its directions, a trigger, or a button.
struct PadSpot {
    bool isButton = true;
    int index = 0;  ///< index of the button, or of the stick's first axis
    friend bool operator==(const PadSpot&, const PadSpot&) = default;
};

/// What one control of a pad does.
struct PadCallout {
    PadSpot spot;
    QString control;    ///< "Left trigger", "Left stick"
    QString does;       ///< "Drive, turn"; empty: it does nothing
    bool stop = false;  ///< whether it stops all robots
    bool held = false;  ///< whether it is held now
};

/// Callouts to the left and right of the drawing of a known pad, each from top to bottom.
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
