#include "widgets/models/live/readings/reading_text.h"

#include <cmath>

#include <QCoreApplication>
#include <QLocale>

#include "core/base/words.h"
#include "widgets/models/numbers.h"
#include "widgets/models/others_text.h"

namespace leitstand {
namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ReadingWords)
};

constexpr int MostDecimals = 9;

int decimalsFor(double value) {
    const double size = std::abs(value);
    if (size >= 1'000.0) return 0;
    if (size >= 10.0 || size == 0.0) return 1;
    if (size >= 1.0) return 2;
    return std::min(MostDecimals, 2 - static_cast<int>(std::floor(std::log10(size))));
}

QString numberWords(double value, std::optional<int> decimals) {
    constexpr double Plain = 1e9;  // larger numbers are written with their power of ten
    if (std::isinf(value)) return value > 0.0 ? QStringLiteral("∞") : QStringLiteral("−∞");
    if (std::abs(value) >= Plain) return QLocale().toString(value, 'e', 3);
    return numberText(value, decimals.value_or(decimalsFor(value)));
}

}  // namespace

QString readingTitle(const std::string& title) {
    return othersText(translate(ReadingTitles, title.c_str()));
}

QString readingText(double value, const std::string& unit, std::optional<int> decimals) {
    if (std::isnan(value)) return QStringLiteral("–");
    QString number = numberWords(value, decimals);
    if (unit.empty()) return number;
    return unit == "°" ? number + QChar(0xb0) : number + QLatin1Char(' ') + othersText(unit);
}

QString rangeText(const std::optional<double>& low, const std::optional<double>& high) {
    const auto number = [](double limit) { return figureText(limit, MostDecimals); };
    if (low && high) return Words::tr("%1 to %2").arg(number(*low), number(*high));
    if (low) return QStringLiteral("≥ ") + number(*low);
    return high ? QStringLiteral("≤ ") + number(*high) : QString();
}

QString limitsText(const ReadingLimits& limits) {
    const QString looks = rangeText(limits.low, limits.high), acts = rangeText(limits.lowAct, limits.highAct);
    return looks + (looks.isEmpty() || acts.isEmpty() ? QString() : QStringLiteral(" / ")) + acts;
}

}  // namespace leitstand
