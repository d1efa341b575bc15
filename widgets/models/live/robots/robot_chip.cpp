#include "widgets/models/live/robots/robot_chip.h"

#include <chrono>
#include <cmath>

#include <QCoreApplication>

#include "core/base/time.h"
#include "core/event/status_samples.h"
#include "core/station/robot_figures.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/link_text.h"
#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct ChipTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RobotChip)
};

/// Joins those of @p parts that are not empty, with dots between.
QString joined(const QStringList& parts) {
    QStringList full = parts;
    full.removeAll(QString());
    return full.join(QStringLiteral(" · "));
}

/// Returns the charge; a dash when the battery's sample is too old.
QString batteryOf(const RobotState& reported, Time now) {
    if (!reported.battery || !std::isfinite(reported.battery->sample.fraction)) return {};
    return isFresh(reported.battery, now, BatteryAge) ? percentText(reported.battery->sample.fraction)
                                                      : QStringLiteral("–\u202f%");
}

/// Returns the charge in full, with its age.
QString batteryDetails(const RobotState& reported, Time now) {
    const QString charge = batteryOf(reported, now);
    if (charge.isEmpty()) return charge;
    if (isFresh(reported.battery, now, BatteryAge)) return ChipTexts::tr("battery %1").arg(charge);
    const double age = toSeconds(now - reported.battery->received);
    return ChipTexts::tr("battery %1, %2")
        .arg(percentText(reported.battery->sample.fraction), lossText({.arrival = age}));
}

/// Returns @p label within a line, with @p name as the name of its mode. The name is written as the language
/// writes it: German has capitals.
QString inALine(const ModeLabel& label, const LatestPtr<ModeSample>& reported, const QString& name) {
    const QString large = reported ? modeName(reported->sample.mode).toUpper() : QString();
    if (large.isEmpty() || !label.text.startsWith(large)) return label.text.toLower();
    return name + label.text.sliced(large.size()).toLower();
}

/// Returns the state of a robot that is not heard, for little room.
QString briefWithoutWord(LinkState link) {
    return link == LinkState::Lost ? ChipTexts::tr("lost") : ChipTexts::tr("waits", "for the robot");
}

}  // namespace

RobotChip robotChipOf(const RobotFace& face, const RobotView& robot, const RobotState& reported, Time now) {
    RobotChip chip;
    chip.face = face;
    chip.link = robot.link.state;
    const ModeLabel label = modeLabelOf(robot, reported.mode);
    chip.mode = label.kind;
    chip.tone = chip.link == LinkState::Lost ? Tone::Attention : Tone::Muted;
    const std::string known = reported.mode ? reported.mode->sample.mode : std::string();
    const QString mode = inALine(label, reported.mode, modeName(known)),
                  brief = inALine(label, reported.mode, modeBrief(known)), battery = batteryOf(reported, now);
    const QString reason = worstReasonText(robot.link);
    const bool talks = chip.link == LinkState::Connected || chip.link == LinkState::Degraded;
    if (talks) {
        QString trip = roundTripText(robot.link), loss = lossShareText(robot.link);
        if (chip.link == LinkState::Degraded && !reason.isEmpty()) trip = reason, loss = QString();
        const QString lost = loss.startsWith(percentText(0.0)) ? QString() : loss;  // none is no news
        chip.figures = {joined({trip, loss, battery}), joined({trip, lost, battery}), joined({trip, battery}),
                        battery};
    } else if (chip.link == LinkState::Lost) {
        // The battery of a silent robot is an old figure: it is left out before the time of silence.
        const QString silence = secondsText(robot.link.silence);
        chip.figures = {joined({silence, battery}), silence};
    }
    chip.figures.removeAll(QString());
    chip.figures.removeDuplicates();
    chip.modes = {mode, talks ? brief : briefWithoutWord(chip.link)};
    chip.modes.removeDuplicates();
    chip.details =
        ChipTexts::tr("%1 (%2): %3 · link %4")
            .arg(face.title, face.letter, joined({mode, label.reason, batteryDetails(reported, now)}),
                 joined({linkStateText(chip.link), reason, roundTripText(robot.link),
                         talks ? lossShareText(robot.link) : QString()}));
    return chip;
}

}  // namespace leitstand
