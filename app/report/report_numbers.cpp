#include "app/report/report_numbers.h"

#include <cmath>

#include <QLocale>

namespace leitstand {

QString reportNumber(double value, int digits) {
    if (!std::isfinite(value)) return QStringLiteral("\u2013");
    if (std::abs(value) < 0.5 * std::pow(10.0, -digits)) value = 0.0;  // no "-0.00"
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(value, 'f', digits);
}

}  // namespace leitstand
