#include "widgets/models/pad/pad_texts.h"

#include <array>

#include <QCoreApplication>

namespace leitstand {
namespace {

struct Say {
    Q_DECLARE_TR_FUNCTIONS(leitstand::PadTexts)
};

QString standardAxis(const PadControl& control) {
    switch (control.index) {
        case standard_axis::LeftX:
            return control.negative ? Say::tr("Left stick left") : Say::tr("Left stick right");
        case standard_axis::LeftY:
            return control.negative ? Say::tr("Left stick up") : Say::tr("Left stick down");
        case standard_axis::RightX:
            return control.negative ? Say::tr("Right stick left") : Say::tr("Right stick right");
        case standard_axis::RightY:
            return control.negative ? Say::tr("Right stick up") : Say::tr("Right stick down");
        case standard_axis::LeftTrigger:
            return Say::tr("Left trigger");
        case standard_axis::RightTrigger:
            return Say::tr("Right trigger");
        default:
            return {};
    }
}

QString standardButton(int index) {
    switch (index) {
        case standard_button::A:
            return QStringLiteral("A");
        case standard_button::B:
            return QStringLiteral("B");
        case standard_button::X:
            return QStringLiteral("X");
        case standard_button::Y:
            return QStringLiteral("Y");
        case standard_button::Back:
            return Say::tr("Back");
        case standard_button::Guide:
            return Say::tr("Guide");
        case standard_button::Start:
            return Say::tr("Start");
        case standard_button::LeftStick:
            return Say::tr("Left stick pressed");
        case standard_button::RightStick:
            return Say::tr("Right stick pressed");
        case standard_button::LeftShoulder:
            return Say::tr("Left shoulder");
        case standard_button::RightShoulder:
            return Say::tr("Right shoulder");
        case standard_button::Up:
            return Say::tr("Cross up");
        case standard_button::Down:
            return Say::tr("Cross down");
        case standard_button::Left:
            return Say::tr("Cross left");
        case standard_button::Right:
            return Say::tr("Cross right");
        default:
            return {};
    }
}

}  // namespace

QString padActionName(PadAction action) {
    switch (action) {
        case PadAction::DeadMan:
            return Say::tr("Hold to drive");
        case PadAction::Forward:
            return Say::tr("Forward");
        case PadAction::Back:
            return Say::tr("Back");
        case PadAction::TurnLeft:
            return Say::tr("Turn left");
        case PadAction::TurnRight:
            return Say::tr("Turn right");
        case PadAction::SlideLeft:
            return Say::tr("Sideways left");
        case PadAction::SlideRight:
            return Say::tr("Sideways right");
        case PadAction::Turbo:
            return Say::tr("Turbo");
        case PadAction::Slow:
            return Say::tr("Slow");
        case PadAction::Stop:
            return Say::tr("STOP all robots");
        case PadAction::PanLeft:
            return Say::tr("Camera left");
        case PadAction::PanRight:
            return Say::tr("Camera right");
        case PadAction::TiltUp:
            return Say::tr("Camera up");
        case PadAction::TiltDown:
            return Say::tr("Camera down");
        case PadAction::WithoutEyes:
            return Say::tr("Hold: without eyes");
    }
    return {};
}

QString padActionHint(PadAction action) {
    switch (action) {
        case PadAction::DeadMan:
            return Say::tr("The robot moves only while this is held; letting it go stops it at once");
        case PadAction::Turbo:
            return Say::tr("All of the robot's speed instead of 60 %");
        case PadAction::Slow:
            return Say::tr("A quarter of the robot's speed");
        case PadAction::WithoutEyes:
            return Say::tr("While it is held, old or missing pictures do not cap the speed");
        case PadAction::Stop:
            return Say::tr(
                "Stops all robots, always: without the trigger, and whatever window has the focus");
        case PadAction::SlideLeft:
        case PadAction::SlideRight:
            return Say::tr("For robots that can drive sideways");
        case PadAction::PanLeft:
        case PadAction::PanRight:
        case PadAction::TiltUp:
        case PadAction::TiltDown:
            return Say::tr("Turns the cameras, also while the robot stands");
        case PadAction::Forward:
        case PadAction::Back:
        case PadAction::TurnLeft:
        case PadAction::TurnRight:
            break;
    }
    return Say::tr("Drives the selected robot while the trigger is held");
}

QString padControlName(const PadControl& control, PadLayout layout) {
    const bool standard = layout == PadLayout::Standard;
    if (control.kind == PadControl::Kind::None) return QStringLiteral("–");
    if (control.kind == PadControl::Kind::Button) {
        const QString name = standard ? standardButton(control.index) : QString();
        return name.isEmpty() ? Say::tr("Button %1").arg(control.index + 1) : name;
    }
    const QString name = standard ? standardAxis(control) : QString();
    if (!name.isEmpty()) return name;
    return Say::tr("Axis %1 %2")
        .arg(control.index + 1)
        .arg(control.negative ? QStringLiteral("−") : QStringLiteral("+"));
}

QString padDriveHint(const PadBindings& bindings) {
    const PadControl& trigger = bindings.at(PadAction::DeadMan);
    if (trigger.kind == PadControl::Kind::None)
        return Say::tr("Nothing moves: no control is bound to “%1”.").arg(padActionName(PadAction::DeadMan));
    return Say::tr("Hold “%1” first, then push the stick; let it go and the robot stands.")
        .arg(padControlName(trigger, bindings.layout));
}

QString padConnectHelp() {
    return Say::tr(
        "Plug one in, or pair it by Bluetooth, at any time: what SDL knows works at once (Xbox, DualShock, "
        "DualSense, Switch Pro, Steam; Logitech and 8BitDo in their X mode). Any other joystick is bound in "
        "the "
        "menu Robot, Gamepad: STOP first. This is what the controls would do:");
}

QString padlessKeys() {
    return Say::tr(
        "Until then keys drive: F2, then W S A D or the arrows; Shift slow, Ctrl fast; Space halts; G "
        "held drives without eyes; Esc stops all robots, always.");
}

}  // namespace leitstand
