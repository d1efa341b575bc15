#include "widgets/models/live/texts/alarm_text.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <string_view>

#include <QCoreApplication>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/robot/link/link_reasons.h"
#include "core/robot/link/reception.h"
#include "core/station/alarms/log_format.h"
#include "widgets/models/live/readings/reading_text.h"
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

QString diskText(const std::string& note, const QString& detail) {
    const ReadPhrase news = log_format::newsIn(note);
    if (!news.phrase)
        return AlarmTexts::tr("log: %1").arg(note.empty() ? detail
                                                          : withoutFile(QString::fromStdString(note)));
    std::vector<std::string> figures;
    for (const std::string& figure : news.values) figures.push_back(loggedFigureText(figure).toStdString());
    const QString words = QCoreApplication::translate("leitstand::LogSays", news.phrase->words);
    return AlarmTexts::tr("log: %1").arg(QString::fromStdString(withValues(words.toStdString(), figures)));
}

QString detailOf(const AlarmCause& cause) {
    return QString::fromStdString(cause.id.detail).replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString diagnosticsText(const AlarmCause& cause) {
    const QString part = robotReasonText(detailOf(cause).toStdString());
    if (!cause.note.empty()) return AlarmTexts::tr("%1: %2").arg(part, robotReasonText(cause.note));
    return cause.id.detail.empty() ? loggedText(cause) : part;  // parts may have no message
}

QString readingAlarmText(const AlarmCause& cause) {
    if (std::isnan(cause.value)) return readingTitle(cause.id.detail);
    return AlarmTexts::tr("%1: %2").arg(readingTitle(cause.id.detail), readingText(cause.value, cause.note));
}

QString degradedText(const AlarmCause& cause) {
    const auto reason = linkReasonFrom(cause.note);
    return AlarmTexts::tr("link: %1")
        .arg(reason ? linkReasonText(*reason) : QString::fromStdString(cause.note));
}

/// What the words of an alarm need of its cause. Without it they are shown as logged.
enum class Needs : std::uint8_t { Nothing, Value, Note };

struct Row {
    const char* key;
    Needs needs;
    QString (*text)(const AlarmCause& cause);
};
constexpr Row Rows[] = {
    {alarm_key::Attitude, Needs::Value,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("tilted: %1 % of where it tips over").arg(numberText(100.0 * cause.value, 0));
     }},
    {alarm_key::RollOver, Needs::Value,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("rolled over, tilted by %1°").arg(numberText(inDegrees(cause.value), 0));
     }},
    {alarm_key::LinkLost, Needs::Value,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("link lost, silent for %1").arg(wholeSeconds(cause.value));
     }},
    {alarm_key::LinkDegraded, Needs::Note, &degradedText},
    {alarm_key::NotReceived, Needs::Note,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("not heard: %1").arg(QString::fromStdString(receptionText(cause.note)));
     }},
    {alarm_key::Battery, Needs::Value, &batteryText},
    {alarm_key::Gas, Needs::Value,
     [](const AlarmCause& cause) { return AlarmTexts::tr("CO₂ %1 ppm").arg(numberText(cause.value, 0)); }},
    {alarm_key::Reading, Needs::Nothing, &readingAlarmText},
    {alarm_key::Bump, Needs::Nothing,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("bumped: %1").arg(robotReasonText(detailOf(cause).toStdString()));
     }},
    {alarm_key::WheelsSpin, Needs::Value,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("wheels turned for %1 m, the map says it stands")
             .arg(numberText(cause.value, 1));
     }},
    {alarm_key::Diagnostics, Needs::Nothing, &diagnosticsText},
    {alarm_key::StopUnanswered, Needs::Value,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("does not answer STOP for %1").arg(wholeSeconds(cause.value));
     }},
    {alarm_key::FrozenPicture, Needs::Value,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("camera %1 repeats one picture for %2")
             .arg(sensorText(cause.id.detail), wholeSeconds(cause.value));
     }},
    {alarm_key::GrantLost, Needs::Note,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("drive control was lost to %1").arg(QString::fromStdString(cause.note));
     }},
    {alarm_key::ClockOffset, Needs::Value, [](const AlarmCause& cause) { return clockText(cause.value); }},
    {alarm_key::UncertainScan, Needs::Value,
     [](const AlarmCause& cause) {
         return AlarmTexts::tr("uncertain scans to be decided on: %1").arg(numberText(cause.value, 0));
     }},
    {alarm_key::Log, Needs::Nothing,
     [](const AlarmCause& cause) { return diskText(cause.note, detailOf(cause)); }},
};

Tone toneOf(const AlarmLine& line) {
    if (line.stage == AlarmStage::Standing)
        return line.severity == AlarmSeverity::Act ? Tone::Act : Tone::Attention;
    return line.stage == AlarmStage::Over && !line.acknowledged ? Tone::Normal : Tone::Muted;
}

}  // namespace

QString alarmText(const AlarmCause& cause) {
    const auto* const row = std::ranges::find(Rows, std::string_view(cause.id.key),
                                              [](const Row& one) { return std::string_view(one.key); });
    if (row == std::end(Rows))
        return cause.text.empty() ? loggedText(cause) : QString::fromStdString(cause.text);
    const bool lacks = (row->needs == Needs::Value && !std::isfinite(cause.value)) ||
                       (row->needs == Needs::Note && cause.note.empty());
    return lacks ? loggedText(cause) : row->text(cause);
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
