#include "widgets/models/times.h"

#include <chrono>

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

QString wallText(Time at, bool tenths) {
    const auto milliseconds =
        std::chrono::duration_cast<std::chrono::milliseconds>(at.time_since_epoch()).count();
    const QDateTime moment = QDateTime::fromMSecsSinceEpoch(milliseconds);
    return timeOfDayText(moment.time(), tenths);
}

}  // namespace leitstand
