#include "widgets/models/live/record_text.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace leitstand {
namespace {

constexpr double FewMinutes = 10.0;

struct RecordTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::RecordText)
};

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
            text.value = RecordTexts::tr("rec · disk %1 min").arg(std::floor(state.minutesLeft));
        }
    }
    if (state.lost > 0) {
        text.tone = Tone::Act;
        text.value = RecordTexts::tr("rec · %1 lost").arg(state.lost);
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

}  // namespace leitstand
