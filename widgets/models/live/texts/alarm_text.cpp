#include "widgets/models/live/texts/alarm_text.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <span>
#include <string_view>

#include <QCoreApplication>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/robot/link/link_reasons.h"
#include "core/robot/link/reception.h"
#include "core/station/alarms/log_format.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/link_text.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct AlarmTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::AlarmLine)
};

QString wholeSeconds(double seconds) {
    return seconds < 99.5 ? AlarmTexts::tr("%1 s").arg(numberText(std::floor(std::max(0.0, seconds)), 0))
                          : secondsText(seconds);
}

QString batteryText(const AlarmCause& cause) {
    return cause.note == "minutes"
               ? AlarmTexts::tr("battery: %1 min left").arg(numberText(cause.value, 0))
               : AlarmTexts::tr("battery: %1 % left").arg(numberText(100.0 * cause.value, 0));
}

QString clockText(double ahead) {
    const QString by = numberText(std::abs(ahead), 1);
    return ahead > 0.0 ? AlarmTexts::tr("its clock is %1 s ahead").arg(by)
                       : AlarmTexts::tr("its clock is %1 s behind").arg(by);
}

/// Keys whose words need the value, and those that need the note.
constexpr std::array<std::string_view, 10> Measured = {
    alarm_key::Attitude,      alarm_key::RollOver,       alarm_key::LinkLost,      alarm_key::Battery,
    alarm_key::Gas,           alarm_key::StopUnanswered, alarm_key::FrozenPicture, alarm_key::ClockOffset,
    alarm_key::UncertainScan, alarm_key::WheelsSpin};
constexpr std::array<std::string_view, 3> Noted = {alarm_key::LinkDegraded, alarm_key::GrantLost,
                                                   alarm_key::NotReceived};

bool isOneOf(std::span<const std::string_view> keys, std::string_view key) {
    return std::ranges::find(keys, key) != keys.end();
}

/// Whether what its words need could not be read out of the log.
bool lacksFigures(const AlarmCause& cause) {
    return (isOneOf(Measured, cause.id.key) && !std::isfinite(cause.value)) ||
           (isOneOf(Noted, cause.id.key) && cause.note.empty());
}

/// Returns the text as logged, without the title of its robot; the key when there is none.
QString loggedText(const AlarmCause& cause) {
    const QString text = QString::fromStdString(cause.text);
    const auto colon = cause.id.robot.empty() ? -1 : text.indexOf(QLatin1String(": "));
    const QString reported = colon < 0 ? text : text.mid(colon + 2);
    return reported.isEmpty()
               ? QString::fromStdString(cause.id.key).replace(QLatin1Char('_'), QLatin1Char(' '))
               : reported;
}

/// Drops the file, so that what is wrong is read first; the message names the file.
QString withoutFile(const QString& text) {
    const auto colon = text.startsWith(QLatin1Char('/')) ? text.indexOf(QLatin1String(": ")) : -1;
    return colon < 0 ? text : text.mid(colon + 2);
}

QString logText(const std::string& note, const QString& detail) {
    const KnownSentence news = log_format::newsIn(note);
    if (news.words == nullptr)
        return AlarmTexts::tr("log: %1").arg(note.empty() ? detail
                                                          : withoutFile(QString::fromStdString(note)));
    std::vector<std::string> figures;
    for (const std::string& figure : news.values) figures.push_back(loggedFigureText(figure).toStdString());
    const QString words = QCoreApplication::translate("leitstand::LogSays", news.words);
    return AlarmTexts::tr("log: %1").arg(QString::fromStdString(withValues(words.toStdString(), figures)));
}

Tone toneOf(const AlarmLine& line) {
    if (line.stage == AlarmStage::Standing)
        return line.severity == AlarmSeverity::Act ? Tone::Act : Tone::Attention;
    return line.stage == AlarmStage::Over && !line.acknowledged ? Tone::Normal : Tone::Muted;
}

}  // namespace

QString alarmText(const AlarmCause& cause) {
    if (lacksFigures(cause)) return loggedText(cause);
    const std::string& key = cause.id.key;
    const QString detail =
        QString::fromStdString(cause.id.detail).replace(QLatin1Char('_'), QLatin1Char(' '));
    const QString note = QString::fromStdString(cause.note);
    if (key == alarm_key::Attitude)
        return AlarmTexts::tr("tilted: %1 % of where it tips over").arg(numberText(100.0 * cause.value, 0));
    if (key == alarm_key::RollOver)
        return AlarmTexts::tr("rolled over, tilted by %1°").arg(numberText(inDegrees(cause.value), 0));
    if (key == alarm_key::LinkLost)
        return AlarmTexts::tr("link lost, silent for %1").arg(wholeSeconds(cause.value));
    if (key == alarm_key::LinkDegraded) {
        const auto reason = linkReasonFrom(cause.note);
        return AlarmTexts::tr("link: %1").arg(reason ? linkReasonText(*reason) : note);
    }
    if (key == alarm_key::NotReceived)
        return AlarmTexts::tr("not heard: %1").arg(QString::fromStdString(receptionText(cause.note)));
    if (key == alarm_key::Battery) return batteryText(cause);
    if (key == alarm_key::Gas) return AlarmTexts::tr("CO₂ %1 ppm").arg(numberText(cause.value, 0));
    if (key == alarm_key::Bump)
        return AlarmTexts::tr("bumped: %1").arg(robotReasonText(detail.toStdString()));
    if (key == alarm_key::WheelsSpin)
        return AlarmTexts::tr("wheels turned for %1 m, the map says it stands")
            .arg(numberText(cause.value, 1));
    // Parts may have no message.
    if (key == alarm_key::Diagnostics && cause.note.empty())
        return detail.isEmpty() ? loggedText(cause) : robotReasonText(detail.toStdString());
    if (key == alarm_key::Diagnostics)
        return AlarmTexts::tr("%1: %2").arg(robotReasonText(detail.toStdString()),
                                            robotReasonText(cause.note));
    if (key == alarm_key::StopUnanswered)
        return AlarmTexts::tr("does not answer STOP for %1").arg(wholeSeconds(cause.value));
    if (key == alarm_key::FrozenPicture)
        return AlarmTexts::tr("camera %1 repeats one picture for %2")
            .arg(sensorText(cause.id.detail), wholeSeconds(cause.value));
    if (key == alarm_key::GrantLost) return AlarmTexts::tr("drive control was lost to %1").arg(note);
    if (key == alarm_key::ClockOffset) return clockText(cause.value);
    if (key == alarm_key::UncertainScan)
        return AlarmTexts::tr("uncertain scans to be decided on: %1").arg(numberText(cause.value, 0));
    if (key == alarm_key::Log) return logText(cause.note, detail);
    return cause.text.empty() ? loggedText(cause) : QString::fromStdString(cause.text);
}

std::vector<AlarmLine> alarmLinesOf(const std::vector<Alarm>& alarms, const std::vector<RobotFace>& faces,
                                    Time now) {
    std::vector<AlarmLine> lines;
    for (const Alarm& alarm : alarms) {
        AlarmLine line;
        line.id = alarm.cause.id;
        const auto face = std::find_if(faces.begin(), faces.end(), [&](const RobotFace& one) {
            return one.name.toStdString() == alarm.cause.id.robot;
        });
        if (face != faces.end()) line.face = *face;
        line.severity = alarm.cause.severity;
        line.acknowledged = alarm.acknowledged;
        line.stage = alarm.ended          ? AlarmStage::Over
                     : alarm.acknowledged ? AlarmStage::Acknowledged
                                          : AlarmStage::Standing;
        line.text = othersText(alarmText(alarm.cause));
        line.since = alarm.ended
                         ? AlarmTexts::tr("over for %1").arg(wholeSeconds(secondsBetween(*alarm.ended, now)))
                         : wholeSeconds(secondsBetween(alarm.since, now));
        line.tone = toneOf(line);
        lines.push_back(line);
    }
    return lines;
}

QString muteText(Time mutedUntil, Time now) {
    const double left = secondsBetween(now, mutedUntil);
    return left > 0.0 ? AlarmTexts::tr("muted for %1 s").arg(numberText(std::ceil(left), 0)) : QString();
}

QString muteBrief(Time mutedUntil, Time now) {
    const double left = secondsBetween(now, mutedUntil);
    return left > 0.0 ? AlarmTexts::tr("%1 s").arg(numberText(std::ceil(left), 0)) : QString();
}

}  // namespace leitstand
