#include "app/report/report_times.h"

#include <chrono>

#include <QDateTime>
#include <QLocale>

namespace leitstand {
namespace {

QDateTime momentOf(Time time) {
    const auto since = std::chrono::floor<std::chrono::milliseconds>(time.time_since_epoch());
    return QDateTime::fromMSecsSinceEpoch(since.count());
}

}  // namespace

QString reportDate(Time time) {
    const QLocale locale;
    QString format = locale.dateFormat(QLocale::ShortFormat);
    if (!format.contains(QLatin1String("yyyy"))) format.replace(QLatin1String("yy"), QLatin1String("yyyy"));
    return locale.toString(momentOf(time).date(), format);
}

QString reportClock(Time time) {
    const QLocale locale;
    QString format = locale.timeFormat(QLocale::ShortFormat);
    if (!format.contains(QLatin1String("ss"))) format.replace(QLatin1String("mm"), QLatin1String("mm:ss"));
    return locale.toString(momentOf(time).time(), format);
}

}  // namespace leitstand
