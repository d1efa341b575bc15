#pragma once

#include <stdexcept>

#include <QSize>
#include <QString>
#include <QStringList>

namespace leitstand::test {

/// How large windows under test are: 1280 x 800, or as the variable LEITSTAND_TEST_SIZE says ("1920x1080",
/// in units that do not depend on the screen's scale).
[[nodiscard]] inline QSize windowSize() {
    const QString reported = qEnvironmentVariable("LEITSTAND_TEST_SIZE");
    if (reported.isEmpty()) return {1280, 800};
    const QStringList sides = reported.split(QLatin1Char('x'));
    const QSize size = sides.size() == 2 ? QSize(sides[0].toInt(), sides[1].toInt()) : QSize();
    if (size.isEmpty())
        throw std::runtime_error("LEITSTAND_TEST_SIZE: expected 1920x1080, found " + reported.toStdString());
    return size;
}

/// How many pixels of the screen one of them is: QT_SCALE_FACTOR.
[[nodiscard]] inline double windowScale() {
    return qEnvironmentVariable("QT_SCALE_FACTOR", QStringLiteral("1")).toDouble();
}

}  // namespace leitstand::test
