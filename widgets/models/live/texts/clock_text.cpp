#include "widgets/models/live/texts/clock_text.h"

#include <cstdlib>

#include <QCoreApplication>

namespace leitstand {
namespace {

constexpr std::chrono::minutes LastMinutes(2);

struct ClockTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ClockText)
};

/// "12:41", "1:02:41"
QString clockDigits(std::chrono::nanoseconds time) {
    const auto seconds = std::abs(std::chrono::duration_cast<std::chrono::seconds>(time).count());
    const QString below = QStringLiteral("%1:%2")
                              .arg(seconds / 60 % 60, 2, 10, QChar(u'0'))
                              .arg(seconds % 60, 2, 10, QChar(u'0'));
    return seconds < 3600 ? below : QStringLiteral("%1:%2").arg(seconds / 3600).arg(below);
}

}  // namespace

ClockText clockText(const MissionClock& clock) {
    ClockText text;
    const QString gone = clockDigits(clock.elapsed);
    const QString state = clock.running ? ClockTexts::tr("running") : ClockTexts::tr("paused");
    if (!clock.left) {
        text.caption = ClockTexts::tr("time");
        text.value = gone;
        text.details = ClockTexts::tr("Mission time %1, %2").arg(gone, state);
    } else {
        // Whole seconds left are rounded up, so that zero is the end.
        const bool over = clock.left->count() <= 0;
        const auto shown = over ? *clock.left : *clock.left + std::chrono::nanoseconds(999'999'999);
        text.caption = over ? ClockTexts::tr("over") : ClockTexts::tr("left");
        text.value = clockDigits(shown);
        text.details = ClockTexts::tr("Mission time %1 of %2, %3").arg(gone, clockDigits(clock.limit), state);
        if (*clock.left <= LastMinutes) text.tone = over ? Tone::Act : Tone::Attention;
    }
    if (!clock.running) text.caption = ClockTexts::tr("paused");
    return text;
}

QStringList clockCaptions() {
    return {ClockTexts::tr("time"), ClockTexts::tr("left"), ClockTexts::tr("over"), ClockTexts::tr("paused")};
}

}  // namespace leitstand
