#include "core/station/pad/pad_bindings.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace leitstand {
namespace {

constexpr std::pair<PadAction, PadAction> Opposites[] = {{PadAction::Forward, PadAction::Back},
                                                         {PadAction::TurnLeft, PadAction::TurnRight},
                                                         {PadAction::SlideLeft, PadAction::SlideRight},
                                                         {PadAction::PanLeft, PadAction::PanRight},
                                                         {PadAction::TiltUp, PadAction::TiltDown}};

/// Whether the two are one thing in the operator's hand.
bool same(const PadControl& one, const PadControl& other) {
    if (one.kind == PadControl::Kind::None || one.kind != other.kind || one.index != other.index)
        return false;
    return one.kind == PadControl::Kind::Button || one.negative == other.negative;
}

bool isStop(const PadBindings& bindings, const PadControl& control) {
    return same(bindings.at(PadAction::Stop), control);
}

/// Takes @p control from whatever it does.
void free(PadBindings& bindings, const PadControl& control) {
    for (PadControl& one : bindings.controls) {
        if (same(one, control)) one = {};
    }
    std::erase_if(bindings.commands, [&](const PadCommand& one) { return same(one.control, control); });
}

}  // namespace

std::array<PadAction, PadActionCount> padActions() {
    std::array<PadAction, PadActionCount> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<PadAction>(i);
    return all;
}

std::string toString(PadAction action) {
    static constexpr std::array<const char*, PadActionCount> Names = {
        "dead_man", "forward", "back",     "turn_left", "turn_right", "slide_left", "slide_right", "turbo",
        "slow",     "stop",    "pan_left", "pan_right", "tilt_up",    "tilt_down",  "without_eyes"};
    return Names[static_cast<std::size_t>(action)];
}

std::optional<PadAction> oppositeOf(PadAction action) {
    for (const auto& [one, other] : Opposites) {
        if (action == one) return other;
        if (action == other) return one;
    }
    return std::nullopt;
}

PadControl padButton(int index) {
    return {.kind = PadControl::Kind::Button, .index = index};
}

PadControl padAxis(int index, int towards, double rest) {
    return {.kind = PadControl::Kind::Axis, .index = index, .negative = towards < 0, .rest = rest};
}

PadControl oppositeOf(const PadControl& control) {
    // A trigger rests at one end and has no other one.
    if (control.kind != PadControl::Kind::Axis || std::abs(control.rest) > 0.5) return {};
    PadControl other = control;
    other.negative = !control.negative;
    return other;
}

double amountOf(const PadControl& control, const PadState& state) {
    if (control.kind == PadControl::Kind::Button) return state.button(control.index) ? 1.0 : 0.0;
    if (control.kind == PadControl::Kind::None) return 0.0;
    const double way = (control.negative ? -1.0 : 1.0) - control.rest;
    const double share = (state.axis(control.index) - control.rest) / way;
    return std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0;
}

double deflectionOf(const PadBindings& bindings, PadAction plus, const PadState& state) {
    return amountOf(bindings.at(plus), state) - amountOf(bindings.at(*oppositeOf(plus)), state);
}

double shapedOf(const PadBindings& bindings, PadAction plus, const PadState& state) {
    const double zone = bindings.deadZone, expo = bindings.expo;
    const auto shaped = [&](PadAction action) {
        const double past =
            std::max(0.0, (amountOf(bindings.at(action), state) - zone) / std::max(1e-6, 1.0 - zone));
        return (1.0 - expo) * past + expo * past * past * past;
    };
    return shaped(plus) - shaped(*oppositeOf(plus));
}

PadBindings defaultBindings(PadLayout layout) {
    PadBindings bindings;
    bindings.layout = layout;
    if (layout == PadLayout::Plain) return bindings;
    namespace axis = standard_axis;
    namespace button = standard_button;
    const auto stick = [&](PadAction action, int index, int towards) {
        bindings.at(action) = padAxis(index, towards);
        bindings.at(*oppositeOf(action)) = padAxis(index, -towards);
    };
    bindings.at(PadAction::DeadMan) = padAxis(axis::LeftTrigger, 1);
    bindings.at(PadAction::Turbo) = padAxis(axis::RightTrigger, 1);
    bindings.at(PadAction::Slow) = padButton(button::RightShoulder);
    bindings.at(PadAction::WithoutEyes) = padButton(button::LeftShoulder);
    bindings.at(PadAction::Stop) = padButton(button::B);
    stick(PadAction::Forward, axis::LeftY, -1);
    stick(PadAction::TurnLeft, axis::LeftX, -1);
    stick(PadAction::PanLeft, axis::RightX, -1);
    stick(PadAction::TiltUp, axis::RightY, -1);
    bindings.commands = {
        {"robot.next", padButton(button::Y)},      {"camera.recentre", padButton(button::RightStick)},
        {"pad.legend", padButton(button::Back)},   {"victim.freeze", padButton(button::X)},
        {"victim.confirm", padButton(button::A)},  {"form.previous", padButton(button::Up)},
        {"form.next", padButton(button::Down)},    {"form.change", padButton(button::Right)},
        {"joints.next", padButton(button::Start)}, {"joints.pad", padButton(button::LeftStick)}};
    return bindings;
}

bool bindPad(PadBindings& bindings, PadAction action, const PadControl& control) {
    const PadControl other = oppositeOf(control);
    const auto opposite = oppositeOf(action);
    const bool both = opposite && other.kind != PadControl::Kind::None;
    if (action != PadAction::Stop && (isStop(bindings, control) || (both && isStop(bindings, other))))
        return false;
    free(bindings, control);
    bindings.at(action) = control;
    if (!both) return true;
    free(bindings, other);
    bindings.at(*opposite) = other;
    return true;
}

bool bindPad(PadBindings& bindings, const std::string& id, const PadControl& control) {
    if (isStop(bindings, control)) return false;
    free(bindings, control);
    std::erase_if(bindings.commands, [&](const PadCommand& one) { return one.id == id; });
    if (control.kind != PadControl::Kind::None) bindings.commands.push_back({id, control});
    return true;
}

PadControl controlOf(const PadBindings& bindings, const std::string& id) {
    const auto found = std::find_if(bindings.commands.begin(), bindings.commands.end(),
                                    [&](const PadCommand& one) { return one.id == id; });
    return found == bindings.commands.end() ? PadControl{} : found->control;
}

}  // namespace leitstand
