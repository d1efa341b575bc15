#include "widgets/models/numbers.h"

#include <cmath>

#include <QLocale>

#include "core/base/pose.h"

namespace leitstand {
namespace {

const QChar Minus(0x2212);
const QString NarrowBlank(QChar(0x202f));

}  // namespace

QString numberText(double value, int decimals) {
    const double smallest = 0.5 * std::pow(10.0, -decimals);
    // What rounds to zero has no sign.
    const double shown = std::abs(value) < smallest ? 0.0 : value;
    return QLocale().toString(shown, 'f', decimals).replace(QLatin1Char('-'), Minus);
}

QString figureText(double value, int decimals) {
    double rounded = std::round(value * std::pow(10.0, decimals));
    for (; decimals > 0 && std::fmod(rounded, 10.0) == 0.0; --decimals) rounded /= 10.0;
    return numberText(value, decimals);
}

QString loggedFigureText(const std::string& reported) {
    const QString text = QString::fromStdString(reported);
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    const auto point = text.indexOf(QLatin1Char('.'));
    return isNumber ? numberText(number, point < 0 ? 0 : static_cast<int>(text.size() - point) - 1) : text;
}

QString countText(std::size_t count) {
    return QLocale().toString(static_cast<qulonglong>(count));
}

QString shortCountText(std::size_t count) {
    const auto value = static_cast<double>(count);
    if (count < 1'000) return countText(count);
    if (count < 100'000) return numberText(value / 1e3, 1) + NarrowBlank + QLatin1Char('k');
    return numberText(value / 1e6, 2) + NarrowBlank + QLatin1Char('M');
}

QString percentText(double share) {
    return numberText(100.0 * share, 0) + NarrowBlank + QLatin1Char('%');
}

QString millimetresText(double metres) {
    return numberText(1e3 * metres, 1);
}

QString degreesText(double radians) {
    return numberText(inDegrees(radians), 1) + QChar(0xb0);
}

QString positionText(const Eigen::Vector3d& metres) {
    return numberText(metres.x(), 2) + QStringLiteral("  ") + numberText(metres.y(), 2) +
           QStringLiteral("  ") + numberText(metres.z(), 2);
}

}  // namespace leitstand
