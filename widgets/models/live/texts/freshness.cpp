#include "widgets/models/live/texts/freshness.h"

#include <cmath>

#include <QCoreApplication>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct FreshnessTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::Freshness)
};

/// Whether the content is old while samples arrive.
bool repeats(const DataAge& age, const FreshnessLimits& limits) {
    return age.content > age.arrival && age.content >= limits.stale;
}

}  // namespace

Freshness freshnessOf(const DataAge& age, const FreshnessLimits& limits) {
    const double seconds = age.seconds();
    if (!std::isfinite(seconds)) return Freshness::Never;
    if (seconds >= limits.lost) return Freshness::Lost;
    return seconds >= limits.stale ? Freshness::Stale : Freshness::Live;
}

QString secondsText(double seconds) {
    if (seconds < 0.9995) return FreshnessTexts::tr("%1 ms").arg(numberText(1e3 * std::max(0.0, seconds), 0));
    if (seconds < 9.95) return FreshnessTexts::tr("%1 s").arg(numberText(seconds, 1));
    if (seconds < 99.5) return FreshnessTexts::tr("%1 s").arg(numberText(seconds, 0));
    return FreshnessTexts::tr("%1 min").arg(numberText(std::floor(seconds / 60.0), 0));
}

QString ageText(const DataAge& age, const FreshnessLimits& limits) {
    if (!std::isfinite(age.seconds())) return FreshnessTexts::tr("no data yet");
    const QString text = secondsText(age.seconds());
    return repeats(age, limits) ? FreshnessTexts::tr("same for %1").arg(text) : text;
}

QString lossText(const DataAge& age, const FreshnessLimits& limits) {
    switch (freshnessOf(age, limits)) {
        case Freshness::Live:
        case Freshness::Stale:
            return {};
        case Freshness::Never:
            return FreshnessTexts::tr("no data yet");
        case Freshness::Lost:
            break;
    }
    // whole seconds: what is lost is not measured, it is counted
    const double seconds = std::floor(age.seconds());
    const QString text =
        seconds < 100.0 ? FreshnessTexts::tr("%1 s").arg(numberText(seconds, 0)) : secondsText(seconds);
    return repeats(age, limits) ? FreshnessTexts::tr("the same picture for %1").arg(text)
                                : FreshnessTexts::tr("no data for %1").arg(text);
}

Tone toneOf(Freshness freshness) {
    return freshness == Freshness::Live ? Tone::Muted : Tone::Attention;
}

}  // namespace leitstand
