#include "widgets/models/pad/pad_texts.h"

#include <array>

#include <QCoreApplication>

namespace leitstand {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::PadTexts)
};

QString standardAxis(const PadControl& control) {
    switch (control.index) {
        case standard_axis::LeftX:
            return control.negative ? Texts::tr("Left stick left") : Texts::tr("Left stick right");
        case standard_axis::LeftY:
            return control.negative ? Texts::tr("Left stick up") : Texts::tr("Left stick down");
        case standard_axis::RightX:
            return control.negative ? Texts::tr("Right stick left") : Texts::tr("Right stick right");
        case standard_axis::RightY:
            return control.negative ? Texts::tr("Right stick up") : Texts::tr("Right stick down");
        case standard_axis::LeftTrigger:
            return Texts::tr("Left trigger");
        case standard_axis::RightTrigger:
            return Texts::tr("Right trigger");
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
            return Texts::tr("Back");
        case standard_button::Guide:
            return Texts::tr("Guide");
        case standard_button::Start:
            return Texts::tr("Start");
        case standard_button::LeftStick:
            return Texts::tr("Left stick pressed");
        case standard_button::RightStick:
            return Texts::tr("Right stick pressed");
        case standard_button::LeftShoulder:
            return Texts::tr("Left shoulder");
        case standard_button::RightShoulder:
            return Texts::tr("Right shoulder");
        case standard_button::Up:
            return Texts::tr("Cross up");
        case standard_button::Down:
            return Texts::tr("Cross down");
        case standard_button::Left:
            return Texts::tr("Cross left");
        case standard_button::Right:
            return Texts::tr("Cross right");
        default:
            return {};
    }
}

}  // namespace

QString padActionName(PadAction action) {
    switch (action) {
        case PadAction::DeadMan:
            return Texts::tr("Hold to drive");
        case PadAction::Forward:
            return Texts::tr("Forward");
        case PadAction::Back:
            return Texts::tr("Back");
        case PadAction::TurnLeft:
            return Texts::tr("Turn left");
        case PadAction::TurnRight:
            return Texts::tr("Turn right");
        case PadAction::SlideLeft:
            return Texts::tr("Sideways left");
        case PadAction::SlideRight:
            return Texts::tr("Sideways right");
        case PadAction::Turbo:
            return Texts::tr("Turbo");
        case PadAction::Slow:
            return Texts::tr("Slow");
        case PadAction::Stop:
            return Texts::tr("STOP all robots");
        case PadAction::PanLeft:
            return Texts::tr("Camera left");
        case PadAction::PanRight:
            return Texts::tr("Camera right");
        case PadAction::TiltUp:
            return Texts::tr("Camera up");
        case PadAction::TiltDown:
            return Texts::tr("Camera down");
        case PadAction::WithoutEyes:
            return Texts::tr("Hold: without eyes");
    }
    return {};
}

QString padActionHint(PadAction action) {
    switch (action) {
        case PadAction::DeadMan:
            return Texts::tr("The robot moves only while this is held; letting it go stops it at once");
        case PadAction::Turbo:
            return Texts::tr("All of the robot's speed instead of 60 %");
        case PadAction::Slow:
            return Texts::tr("A quarter of the robot's speed");
        case PadAction::WithoutEyes:
            return Texts::tr("While it is held, old or missing pictures do not cap the speed");
        case PadAction::Stop:
            return Texts::tr(
                "Stops all robots, always: without the trigger, and whatever window has the focus");
        case PadAction::SlideLeft:
        case PadAction::SlideRight:
            return Texts::tr("For robots that can drive sideways");
        case PadAction::PanLeft:
        case PadAction::PanRight:
        case PadAction::TiltUp:
        case PadAction::TiltDown:
            return Texts::tr("Turns the cameras, also while the robot stands");
        case PadAction::Forward:
        case PadAction::Back:
        case PadAction::TurnLeft:
        case PadAction::TurnRight:
            break;
    }
    return Texts::tr("Drives the selected robot while the trigger is held");
}

QString padControlName(const PadControl& control, PadLayout layout) {
    const bool standard = layout == PadLayout::Standard;
    if (control.kind == PadControl::Kind::None) return QStringLiteral("–");
    if (control.kind == PadControl::Kind::Button) {
        const QString name = standard ? standardButton(control.index) : QString();
        return name.isEmpty() ? Texts::tr("Button %1").arg(control.index + 1) : name;
    }
    const QString name = standard ? standardAxis(control) : QString();
    if (!name.isEmpty()) return name;
    return Texts::tr("Axis %1 %2")
        .arg(control.index + 1)
        .arg(control.negative ? QStringLiteral("−") : QStringLiteral("+"));
}

QString padDriveHint(const PadBindings& bindings) {
    const PadControl& trigger = bindings.at(PadAction::DeadMan);
    if (trigger.kind == PadControl::Kind::None)
        return Texts::tr("Nothing moves: no control is bound to “%1”.")
            .arg(padActionName(PadAction::DeadMan));
    return Texts::tr("Hold “%1” first, then push the stick; let it go and the robot stands.")
        .arg(padControlName(trigger, bindings.layout));
}

QString padConnectHelp() {
    return Texts::tr(
        "Plug one in, or pair it by Bluetooth, at any time: what SDL knows works at once (Xbox, DualShock, "
        "DualSense, Switch Pro, Steam; Logitech and 8BitDo in their X mode). Any other joystick is bound in "
        "the "
        "menu Robot, Gamepad: STOP first. This is what the controls would do:");
}

QString padlessKeys() {
    return Texts::tr(
        "Until then keys drive: F2, then W S A D or the arrows; Shift slow, Ctrl fast; Space halts; G "
        "held drives without eyes; Esc stops all robots, always.");
}

}  // namespace leitstand
