#include "widgets/models/pad/pad_texts.h"

#include <array>

#include <QCoreApplication>

namespace leitstand {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("PadTexts", text);
}

QString standardAxis(const PadControl& control) {
    switch (control.index) {
        case standard_axis::LeftX:
            return control.negative ? tr("Left stick left") : tr("Left stick right");
        case standard_axis::LeftY:
            return control.negative ? tr("Left stick up") : tr("Left stick down");
        case standard_axis::RightX:
            return control.negative ? tr("Right stick left") : tr("Right stick right");
        case standard_axis::RightY:
            return control.negative ? tr("Right stick up") : tr("Right stick down");
        case standard_axis::LeftTrigger:
            return tr("Left trigger");
        case standard_axis::RightTrigger:
            return tr("Right trigger");
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
            return tr("Back");
        case standard_button::Guide:
            return tr("Guide");
        case standard_button::Start:
            return tr("Start");
        case standard_button::LeftStick:
            return tr("Left stick pressed");
        case standard_button::RightStick:
            return tr("Right stick pressed");
        case standard_button::LeftShoulder:
            return tr("Left shoulder");
        case standard_button::RightShoulder:
            return tr("Right shoulder");
        case standard_button::Up:
            return tr("Cross up");
        case standard_button::Down:
            return tr("Cross down");
        case standard_button::Left:
            return tr("Cross left");
        case standard_button::Right:
            return tr("Cross right");
        default:
            return {};
    }
}

}  // namespace

QString padActionName(PadAction action) {
    switch (action) {
        case PadAction::DeadMan:
            return tr("Hold to drive");
        case PadAction::Forward:
            return tr("Forward");
        case PadAction::Back:
            return tr("Back");
        case PadAction::TurnLeft:
            return tr("Turn left");
        case PadAction::TurnRight:
            return tr("Turn right");
        case PadAction::SlideLeft:
            return tr("Sideways left");
        case PadAction::SlideRight:
            return tr("Sideways right");
        case PadAction::Turbo:
            return tr("Turbo");
        case PadAction::Slow:
            return tr("Slow");
        case PadAction::Stop:
            return tr("STOP all robots");
        case PadAction::PanLeft:
            return tr("Camera left");
        case PadAction::PanRight:
            return tr("Camera right");
        case PadAction::TiltUp:
            return tr("Camera up");
        case PadAction::TiltDown:
            return tr("Camera down");
        case PadAction::WithoutEyes:
            return tr("Hold: without eyes");
    }
    return {};
}

QString padActionHint(PadAction action) {
    switch (action) {
        case PadAction::DeadMan:
            return tr("The robot moves only while this is held; letting it go stops it at once");
        case PadAction::Turbo:
            return tr("All of the robot's speed instead of 60 %");
        case PadAction::Slow:
            return tr("A quarter of the robot's speed");
        case PadAction::WithoutEyes:
            return tr("While it is held, old or missing pictures do not cap the speed");
        case PadAction::Stop:
            return tr("Stops all robots, always: without the trigger, and whatever window has the focus");
        case PadAction::SlideLeft:
        case PadAction::SlideRight:
            return tr("For robots that can drive sideways");
        case PadAction::PanLeft:
        case PadAction::PanRight:
        case PadAction::TiltUp:
        case PadAction::TiltDown:
            return tr("Turns the cameras, also while the robot stands");
        default:
            return tr("Drives the selected robot while the trigger is held");
    }
}

QString padControlName(const PadControl& control, PadLayout layout) {
    const bool standard = layout == PadLayout::Standard;
    if (control.kind == PadControl::Kind::None) return QStringLiteral("–");
    if (control.kind == PadControl::Kind::Button) {
        const QString name = standard ? standardButton(control.index) : QString();
        return name.isEmpty() ? tr("Button %1").arg(control.index + 1) : name;
    }
    const QString name = standard ? standardAxis(control) : QString();
    if (!name.isEmpty()) return name;
    return tr("Axis %1 %2")
        .arg(control.index + 1)
        .arg(control.negative ? QStringLiteral("−") : QStringLiteral("+"));
}

QString padDriveHint(const PadBindings& bindings) {
    const PadControl& trigger = bindings.at(PadAction::DeadMan);
    if (trigger.kind == PadControl::Kind::None)
        return tr("Nothing moves: no control is bound to “%1”.").arg(padActionName(PadAction::DeadMan));
    return tr("Hold “%1” first, then push the stick; let it go and the robot stands.")
        .arg(padControlName(trigger, bindings.layout));
}

}  // namespace leitstand
