#include "widgets/models/live/texts/mode_label.h"

#include <algorithm>
#include <string_view>

#include <QCoreApplication>

#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_format.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/goal_text.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct ModeTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ModeLabel)
};

ModeLabel labelOf(const ModeSample& mode) {
    ModeKind kind = mode.autonomous ? ModeKind::Autonomous : ModeKind::Teleoperation;
    if (mode.mode == "stopped") kind = ModeKind::Stopped;
    return {kind, modeName(mode.mode).toUpper(), robotReasonText(mode.reason),
            modeBrief(mode.mode).toUpper()};
}

/// Returns the label of a robot that does not report its mode.
ModeLabel labelWithoutWord(const RobotView& robot) {
    if (robot.drive.driving)
        return {ModeKind::Teleoperation,
                ModeTexts::tr("TELEOPERATION"),
                {},
                modeBrief("teleoperation").toUpper()};
    // While it is on its way there is something to say of it.
    if (const QString way = goalNote(robot.navigation); !way.isEmpty())
        return {ModeKind::Autonomous, ModeTexts::tr("TO ITS GOAL"), way, ModeTexts::tr("GOAL")};
    const auto& streams = robot.link.streams;
    const bool reports = std::any_of(streams.begin(), streams.end(),
                                     [](const StreamStatus& one) { return one.role == StreamRole::Mode; });
    if (!streams.empty() && !reports)
        return {ModeKind::Stopped, ModeTexts::tr("NO MODES"), ModeTexts::tr("others may drive it, too")};
    return {ModeKind::Stopped, ModeTexts::tr("MODE UNKNOWN"), ModeTexts::tr("the robot tells none")};
}

/// Returns the value in a robot's words: figures as the window's language writes them, modes by their names.
QString valueText(const robot_format::Part& part) {
    // Compares the letters: equal texts of two files may have two addresses.
    if (part.words == std::string_view(robot_format::CannotBeAskedFor)) return modeName(part.value);
    return loggedFigureText(part.value);
}

}  // namespace

QString robotReasonText(const std::string& reported) {
    QStringList texts;
    for (const robot_format::Part& part : robot_format::partsOf(reported)) {
        if (part.words == nullptr) {
            texts += othersText(part.value);
            continue;
        }
        texts += QCoreApplication::translate("leitstand::RobotSays", part.words)
                     .replace(QStringLiteral("{}"), valueText(part));
    }
    return texts.join(QStringLiteral("; "));
}

QString modeName(const std::string& mode) {
    if (mode == "stopped") return ModeTexts::tr("stopped");
    if (mode == "teleoperation") return ModeTexts::tr("teleoperation");
    if (mode == "safe_teleoperation") return ModeTexts::tr("safe teleoperation");
    if (mode == "explore") return ModeTexts::tr("explore");
    if (mode == "victim_approach") return ModeTexts::tr("victim approach");
    if (mode == "remote") return ModeTexts::tr("radio remote");
    return othersText(mode).replace(QLatin1Char('_'), QLatin1Char(' ')).simplified();
}

QString modeBrief(const std::string& mode) {
    if (mode == "teleoperation") return ModeTexts::tr("teleop");
    if (mode == "safe_teleoperation") return ModeTexts::tr("safe teleop");
    if (mode == "victim_approach") return ModeTexts::tr("approach");
    if (mode == "remote") return ModeTexts::tr("remote");
    return modeName(mode);
}

ModeLabel modeLabelOf(const RobotView& robot, const LatestPtr<ModeSample>& reported) {
    switch (robot.link.state) {
        case LinkState::NeverSeen:
            return {ModeKind::Stopped, ModeTexts::tr("NOT HEARD YET"), ModeTexts::tr("waits for the robot")};
        case LinkState::Lost: {
            const QString silence = secondsText(robot.link.silence);
            const QString last =
                reported
                    ? ModeTexts::tr("silent for %1 · was in %2").arg(silence, modeName(reported->sample.mode))
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
    ModeLabel label =
        reported && !reported->sample.mode.empty() ? labelOf(reported->sample) : labelWithoutWord(robot);
    if (robot.drive.focus && robot.drive.sight.overridden)
        label.text = label.brief = ModeTexts::tr("%1 · OVERRIDE").arg(label.text);
    return label;
}

bool drivesItself(const RobotView& robot, const LatestPtr<ModeSample>& reported) {
    const ModeKind kind = modeLabelOf(robot, reported).kind;
    if (kind != ModeKind::Lost) return kind == ModeKind::Autonomous;
    if (!goalNote(robot.navigation).isEmpty()) return true;
    return reported && labelOf(reported->sample).kind == ModeKind::Autonomous && !robot.stop.stopped;
}

}  // namespace leitstand
