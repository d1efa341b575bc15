#include "widgets/models/timeline/timeline_text.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QStringList>

#include "core/station/alarms/logged_alarm.h"
#include "core/station/preflight/brake_format.h"
#include "widgets/models/live/texts/alarm_text.h"
#include "widgets/models/live/texts/mode_label.h"
#include "widgets/models/map/decision_text.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"
#include "widgets/models/times.h"
#include "widgets/models/victims/move_text.h"

namespace leitstand {
namespace {

struct TimelineTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::Timeline)
};

using Kind = TimelineMark::Kind;

QString words(const std::string& key) {
    return QString::fromStdString(key).replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString victimText(const TimelineMark& mark) {
    const QString name = othersText(mark.name);
    if (mark.key == "confirmed") return TimelineTexts::tr("%1 confirmed").arg(name);
    if (mark.key == "discarded") return TimelineTexts::tr("%1 discarded").arg(name);
    return TimelineTexts::tr("%1 filed").arg(name);
}

/// Returns a cue, or what a robot reports to have seen, in words.
QString seenText(const std::string& kind) {
    if (kind == "victim") return TimelineTexts::tr("a victim");
    if (kind == "heat") return TimelineTexts::tr("heat");
    if (kind == "motion") return TimelineTexts::tr("motion");
    if (kind == "sound") return TimelineTexts::tr("sound");
    if (kind == "co2") return TimelineTexts::tr("CO₂");
    if (kind == "code") return TimelineTexts::tr("a code");
    if (kind == "tag") return TimelineTexts::tr("a victim's tag");
    if (kind == "hazard") return TimelineTexts::tr("a hazard sign");
    if (kind == "object") return TimelineTexts::tr("an object");
    if (kind == "sighting") return TimelineTexts::tr("the robot's own sighting");
    return words(kind);
}

QString sightingText(const TimelineMark& mark) {
    const QString what = seenText(mark.key);
    return mark.text.empty()
               ? TimelineTexts::tr("the robot saw %1").arg(what)
               : TimelineTexts::tr("the robot saw %1: %2").arg(what, robotReasonText(mark.text));
}

QString candidateText(const TimelineMark& mark) {
    const QString what = seenText(mark.name);
    if (mark.key == "dismissed") return TimelineTexts::tr("candidate dismissed: %1").arg(what);
    QStringList cues;
    for (const QString& cue : othersText(mark.text).split(QStringLiteral(", "), Qt::SkipEmptyParts))
        cues += mark.name == "victim" ? seenText(cue.toStdString()) : cue;
    const QString sure =
        TimelineTexts::tr("candidate: %1, %2", "a victim, 72 %").arg(what, percentText(mark.confidence));
    return cues.empty() ? sure : QStringLiteral("%1 (%2)").arg(sure, cues.join(QStringLiteral(", ")));
}

QString findMovedText(const TimelineMark& mark) {
    using Cause = FindMove::Cause;
    const Cause cause = mark.key == "registration"   ? Cause::Registration
                        : mark.key == "loop closure" ? Cause::LoopClosure
                        : mark.key == "operator"     ? Cause::Operator
                                                     : Cause::Undo;
    return TimelineTexts::tr("%1 moved %2 m, since %3 (%4)")
        .arg(othersText(mark.name), numberText((mark.to - mark.from).norm(), 2), causeText(cause),
             positionText(mark.from) + QStringLiteral(" → ") + positionText(mark.to));
}

QString undoMarkText(const TimelineMark& mark) {
    const auto thing = undoneThing(mark.text);
    const QString what = thing ? undoneText(*thing) : othersText(mark.text);
    if (mark.key == "redo")
        return what.isEmpty() ? TimelineTexts::tr("done again")
                              : TimelineTexts::tr("done again: %1").arg(what);
    return what.isEmpty() ? TimelineTexts::tr("undone") : TimelineTexts::tr("undone: %1").arg(what);
}

QString alarmMarkText(const TimelineMark& mark) {
    AlarmSample reported;
    reported.robot = mark.robot;
    reported.key = mark.key;
    reported.text = mark.text;
    return alarmText(loggedCause(reported));
}

QString contentOf(const TimelineMark& mark) {
    const QString text = othersText(mark.text);
    switch (mark.kind) {
        case Kind::Victim:
            return victimText(mark);
        case Kind::Candidate:
            return candidateText(mark);
        case Kind::Alarm:
            return TimelineTexts::tr("alarm: %1").arg(alarmMarkText(mark));
        case Kind::Note:
            return TimelineTexts::tr("note: %1").arg(QString::fromStdString(brakeWorded(mark.text)));
        case Kind::Decision:
            return mark.key == "poses" ? TimelineTexts::tr("decision on scans") : undoMarkText(mark);
        case Kind::Mode:
            return text.isEmpty() ? TimelineTexts::tr("mode: %1").arg(modeName(mark.key))
                                  : TimelineTexts::tr("mode: %1 (%2)")
                                        .arg(modeName(mark.key), robotReasonText(mark.text));
        case Kind::Bump:
            return TimelineTexts::tr("bumped: %1").arg(robotReasonText(words(mark.key).toStdString()));
        case Kind::Moved:
            return findMovedText(mark);
        case Kind::Sighting:
            return sightingText(mark);
        case Kind::Session:
            break;
    }
    return mark.key == "end" ? TimelineTexts::tr("recording ended (%1)").arg(text)
                             : TimelineTexts::tr("recording began (%1)").arg(text);
}

MarkShape shapeOf(Kind kind) {
    switch (kind) {
        case Kind::Victim:
            return MarkShape::Disc;
        case Kind::Candidate:
            return MarkShape::Drop;
        case Kind::Alarm:
            return MarkShape::Triangle;
        case Kind::Note:
            return MarkShape::Square;
        case Kind::Decision:
            return MarkShape::Diamond;
        case Kind::Mode:
            return MarkShape::Bar;
        case Kind::Bump:
            return MarkShape::Cross;
        case Kind::Moved:
            return MarkShape::Arrow;
        case Kind::Sighting:
            return MarkShape::Ring;
        case Kind::Session:
            break;
    }
    return MarkShape::Flag;
}

Tone toneOf(const TimelineMark& mark) {
    if (mark.kind == Kind::Alarm) return mark.act ? Tone::Act : Tone::Attention;
    if (mark.kind == Kind::Bump) return Tone::Attention;
    const bool aside = mark.kind == Kind::Session || mark.kind == Kind::Moved || mark.kind == Kind::Mode ||
                       mark.key == "discarded" || mark.key == "dismissed";
    return aside ? Tone::Muted : Tone::Normal;
}

}  // namespace

QString markText(const TimelineMark& mark, const std::vector<RobotFace>& faces) {
    QStringList parts;
    const auto face = std::find_if(faces.begin(), faces.end(), [&mark](const RobotFace& one) {
        return one.name.toStdString() == mark.robot;
    });
    if (face != faces.end()) {
        parts += face->letter;
    } else if (!mark.robot.empty()) {
        parts += othersText(mark.robot);
    }
    parts += contentOf(mark);
    return parts.join(QStringLiteral(" · "));
}

std::vector<TimelineGlyph> glyphsOf(const std::vector<TimelineMark>& marks, const TimelineAxis& axis,
                                    const std::vector<RobotFace>& faces) {
    std::vector<TimelineGlyph> glyphs;
    for (const TimelineMark& mark : marks) {
        TimelineGlyph glyph;
        glyph.mark = mark;
        glyph.place = axis.placeOf(mark.at);
        glyph.shape = shapeOf(mark.kind);
        glyph.tone = toneOf(mark);
        if (mark.kind == Kind::Victim && mark.name.size() > 1)
            glyph.letter = QString::fromStdString(mark.name.front() == 'V' ? mark.name.substr(1) : mark.name);
        if (mark.kind == Kind::Candidate) glyph.letter = QStringLiteral("?");
        glyph.details = wallText(mark.at) + QStringLiteral(" · ") + markText(mark, faces);
        glyphs.push_back(std::move(glyph));
    }
    return glyphs;
}

QString recordedText(std::chrono::nanoseconds time) {
    const std::int64_t tenths = std::max<std::int64_t>(0, time.count() / 100'000'000);
    const std::int64_t hours = tenths / 36'000, minutes = tenths / 600 % 60;
    const QString seconds = QStringLiteral("%1%2%3")
                                .arg(tenths / 10 % 60, 2, 10, QLatin1Char('0'))
                                .arg(QLocale().decimalPoint())
                                .arg(tenths % 10);
    if (hours == 0) return QStringLiteral("%1:%2").arg(minutes).arg(seconds);
    return QStringLiteral("%1:%2:%3").arg(hours).arg(minutes, 2, 10, QLatin1Char('0')).arg(seconds);
}

QString rateText(double rate) {
    if (rate == 0.0) return TimelineTexts::tr("stands");
    const double size = std::abs(rate);
    const int decimals = size >= 1.0 ? 0 : size * 10.0 == std::round(size * 10.0) ? 1 : 2;
    const QString text = numberText(size, decimals) + QChar(0xd7);
    return rate < 0.0 ? TimelineTexts::tr("backwards %1").arg(text) : text;
}

double nextRate(double rate, bool faster) {
    static constexpr std::array Rates = {0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0};
    const double size = rate == 0.0 ? 1.0 : std::abs(rate);
    double next = size;
    if (faster) {
        const auto found = std::upper_bound(Rates.begin(), Rates.end(), size);
        next = found == Rates.end() ? Rates.back() : *found;
    } else {
        const auto found = std::lower_bound(Rates.begin(), Rates.end(), size);
        next = found == Rates.begin() ? Rates.front() : *std::prev(found);
    }
    return rate < 0.0 ? -next : next;
}

}  // namespace leitstand
