#include "widgets/models/live/texts/record_text.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace leitstand {
namespace {

constexpr double FewMinutes = 10.0;
constexpr unsigned long long ManyLost = 9'999;  ///< more are not counted in the bar, but in its details

struct RecordTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RecordText)
};

QString diskValue(double minutes) {
    return RecordTexts::tr("rec · disk %1 min").arg(std::floor(minutes));
}

QString lostValue(unsigned long long lost) {
    return RecordTexts::tr("rec · %1 lost")
        .arg(lost <= ManyLost ? QString::number(lost) : QStringLiteral("%1+").arg(ManyLost));
}

}  // namespace

RecordText recordText(const RecordState& state) {
    const QLocale locale;
    RecordText text;
    QStringList details{
        RecordTexts::tr("Recorded into %1").arg(state.folder),
        RecordTexts::tr("%1 MB in this session").arg(locale.toString(state.megabytes, 'f', 1))};
    text.value = RecordTexts::tr("rec");
    if (std::isfinite(state.minutesLeft)) {
        details += RecordTexts::tr("the disk lasts %1 min")
                       .arg(locale.toString(std::floor(state.minutesLeft), 'f', 0));
        if (state.minutesLeft < FewMinutes) {
            text.tone = Tone::Attention;
            text.value = diskValue(state.minutesLeft);
        }
    }
    if (state.lost > 0) {
        text.tone = Tone::Act;
        text.value = lostValue(state.lost);
        details += RecordTexts::tr("%1 events could not be written").arg(state.lost);
    }
    if (!state.problem.isEmpty()) {
        text.tone = Tone::Act;
        text.value = RecordTexts::tr("not recording");
        details += state.problem;
    }
    text.details = details.join(QStringLiteral("\n"));
    return text;
}

QStringList recordValues() {
    return {RecordTexts::tr("rec"), RecordTexts::tr("not recording"), diskValue(8.0),
            lostValue(ManyLost + 1)};
}

}  // namespace leitstand
