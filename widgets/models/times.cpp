#include "widgets/models/times.h"

#include <QLocale>

namespace leitstand {

QString timeOfDayText(const QTime& moment, bool tenths) {
    const QLocale locale;
    QString format = locale.timeFormat(QLocale::ShortFormat);
    if (!format.contains(QLatin1String("ss"))) format.replace(QLatin1String("mm"), QLatin1String("mm:ss"));
    if (tenths)
        format.replace(QLatin1String("ss"),
                       QStringLiteral("ss'%1%2'").arg(locale.decimalPoint()).arg(moment.msec() / 100));
    return locale.toString(moment, format);
}

}  // namespace leitstand
