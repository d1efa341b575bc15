#include "widgets/models/live/mode_label.h"

#include <QCoreApplication>

#include "widgets/models/live/freshness.h"

namespace leitstand {
namespace {

struct ModeTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ModeLabel)
};

ModeLabel labelOf(const ModeSample& mode) {
    ModeKind kind = mode.autonomous ? ModeKind::Autonomous : ModeKind::Teleoperation;
    if (mode.mode == "stopped") kind = ModeKind::Stopped;
    return {kind, modeName(mode.mode).toUpper(), QString::fromStdString(mode.reason)};
}

/// Of robots that do not tell their mode.
ModeLabel labelWithoutWord(const RobotView& robot) {
    if (robot.drive.driving) return {ModeKind::Teleoperation, ModeTexts::tr("TELEOPERATION"), {}};
    return {ModeKind::Stopped, ModeTexts::tr("MODE UNKNOWN"), ModeTexts::tr("the robot tells none")};
}

}  // namespace

QString modeName(const std::string& mode) {
    if (mode == "stopped") return ModeTexts::tr("stopped");
    if (mode == "teleoperation") return ModeTexts::tr("teleoperation");
    if (mode == "safe_teleoperation") return ModeTexts::tr("safe teleoperation");
    if (mode == "explore") return ModeTexts::tr("explore");
    if (mode == "victim_approach") return ModeTexts::tr("victim approach");
    if (mode == "remote") return ModeTexts::tr("radio remote");
    return QString::fromStdString(mode).replace(QLatin1Char('_'), QLatin1Char(' ')).simplified();
}

ModeLabel modeLabelOf(const RobotView& robot, const std::optional<Latest<ModeSample>>& said) {
    switch (robot.link.state) {
        case LinkState::NeverSeen:
            return {ModeKind::Stopped, ModeTexts::tr("NOT HEARD YET"), ModeTexts::tr("waits for the robot")};
        case LinkState::Lost: {
            const QString silence = secondsText(robot.link.silence);
            const QString last =
                said ? ModeTexts::tr("silent for %1 · was in %2").arg(silence, modeName(said->sample.mode))
                     : ModeTexts::tr("silent for %1").arg(silence);
            return {ModeKind::Lost, ModeTexts::tr("LINK LOST"), last};
        }
        case LinkState::Connected:
        case LinkState::Degraded:
            break;
    }
    if (robot.stop.sent || robot.stop.stopped) {
        return {ModeKind::Stop, ModeTexts::tr("STOP"), {}};
    }
    ModeLabel label = said && !said->sample.mode.empty() ? labelOf(said->sample) : labelWithoutWord(robot);
    if (robot.drive.focus && robot.drive.sight.overridden)
        label.text = ModeTexts::tr("%1 · OVERRIDE").arg(label.text);
    return label;
}

}  // namespace leitstand
