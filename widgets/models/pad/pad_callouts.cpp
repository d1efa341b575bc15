#include "widgets/models/pad/pad_callouts.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include <QCoreApplication>
#include <QStringList>

namespace leitstand {
namespace {

using ControlKind = PadControl::Kind;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::PadCallouts)
};

/// Returns one word for both ends of a stick.
QString shortName(PadAction action) {
    switch (action) {
        case PadAction::Forward:
        case PadAction::Back:
            return Texts::tr("drive");
        case PadAction::TurnLeft:
        case PadAction::TurnRight:
            return Texts::tr("turn");
        case PadAction::SlideLeft:
        case PadAction::SlideRight:
            return Texts::tr("sideways");
        case PadAction::PanLeft:
        case PadAction::PanRight:
        case PadAction::TiltUp:
        case PadAction::TiltDown:
            return Texts::tr("cameras");
        case PadAction::DeadMan:
        case PadAction::Turbo:
        case PadAction::Slow:
        case PadAction::Stop:
        case PadAction::WithoutEyes:
            break;
    }
    return padActionName(action);
}

/// @p of: controls that belong to the spot, for example the axes of a stick.
PadCallout calloutOf(const PadSpot& spot, const QString& control, const std::vector<PadControl>& of,
                     bool whole, const PadBindings& bindings, const std::vector<PadCommandFace>& commands,
                     const PadState& state) {
    PadCallout callout{.spot = spot, .control = control, .does = {}};
    QStringList texts;
    const auto belongs = [&](const PadControl& one) {
        return std::any_of(of.begin(), of.end(), [&](const PadControl& other) {
            return one.kind != ControlKind::None && one.kind == other.kind && one.index == other.index;
        });
    };
    const auto add = [&](const PadControl& one, const QString& text) {
        if (!texts.contains(text)) texts += text;
        if (amountOf(one, state) >= bindings.press) callout.held = true;
    };
    for (const PadAction action : padActions()) {
        if (!belongs(bindings.at(action))) continue;
        add(bindings.at(action), whole ? shortName(action) : padActionName(action));
        callout.stop = callout.stop || action == PadAction::Stop;
    }
    for (const PadCommand& command : bindings.commands) {
        if (!belongs(command.control)) continue;
        const auto face = std::find_if(commands.begin(), commands.end(),
                                       [&](const PadCommandFace& one) { return one.id == command.id; });
        if (face != commands.end()) add(command.control, face->text);
    }
    callout.does = texts.join(QStringLiteral(", "));
    return callout;
}

}  // namespace

PadCallouts padCallouts(const PadBindings& bindings, const std::vector<PadCommandFace>& commands,
                        const PadState& state) {
    namespace axis = standard_axis;
    namespace button = standard_button;
    const auto one = [&](int index) {
        return calloutOf({true, index}, padControlName(padButton(index), PadLayout::Standard),
                         {padButton(index)}, false, bindings, commands, state);
    };
    const auto trigger = [&](int index) {
        return calloutOf({false, index}, padControlName(padAxis(index, 1), PadLayout::Standard),
                         {padAxis(index, 1)}, false, bindings, commands, state);
    };
    const auto stick = [&](int index, const QString& name) {
        return calloutOf({false, index}, name, {padAxis(index, 1), padAxis(index + 1, 1)}, true, bindings,
                         commands, state);
    };
    PadCallouts callouts;
    callouts.left = {trigger(axis::LeftTrigger), one(button::LeftShoulder),
                     one(button::Back),          stick(axis::LeftX, Texts::tr("Left stick")),
                     one(button::LeftStick),     one(button::Up),
                     one(button::Left),          one(button::Right),
                     one(button::Down)};
    callouts.right = {trigger(axis::RightTrigger),
                      one(button::RightShoulder),
                      one(button::Start),
                      one(button::Y),
                      one(button::X),
                      one(button::B),
                      one(button::A),
                      stick(axis::RightX, Texts::tr("Right stick")),
                      one(button::RightStick)};
    return callouts;
}

std::vector<PadCallout> padList(const PadBindings& bindings, const std::vector<PadCommandFace>& commands,
                                const PadState& state) {
    std::vector<PadCallout> list;
    const auto add = [&](const PadControl& control, const QString& does, bool stop) {
        if (control.kind == ControlKind::None) return;
        list.push_back({.spot = {control.kind == ControlKind::Button, control.index},
                        .control = padControlName(control, bindings.layout),
                        .does = does,
                        .stop = stop,
                        .held = amountOf(control, state) >= bindings.press});
    };
    for (const PadAction action : padActions())
        add(bindings.at(action), padActionName(action), action == PadAction::Stop);
    for (const PadCommandFace& command : commands) add(controlOf(bindings, command.id), command.text, false);
    return list;
}

}  // namespace leitstand
