#include "widgets/models/map/scanner_text.h"

#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "widgets/models/numbers.h"

namespace leitstand {
namespace {

struct ScannerTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::ScannerFeature)
};

QString centimetres(double metres) {
    return numberText(100.0 * std::abs(metres), 1) + QStringLiteral(" cm");
}

QString angle(double radians) {
    return numberText(std::abs(inDegrees(radians)), 1) + QStringLiteral("°");
}

/// Returns how its place and direction differ from those described.
QString mountText(const ScannerCorrection& more) {
    QStringList off;
    const auto add = [&off](double value, const QString& text, const QString& by) {
        if (value != 0.0) off << text.arg(by);
    };
    add(more.x, more.x > 0.0 ? ScannerTexts::tr("%1 farther ahead") : ScannerTexts::tr("%1 farther back"),
        centimetres(more.x));
    add(more.y, more.y > 0.0 ? ScannerTexts::tr("%1 farther left") : ScannerTexts::tr("%1 farther right"),
        centimetres(more.y));
    add(more.yaw,
        more.yaw > 0.0 ? ScannerTexts::tr("turned %1 to the left")
                       : ScannerTexts::tr("turned %1 to the right"),
        angle(more.yaw));
    return off.join(QStringLiteral(", "));
}

}  // namespace

QString scannerQuestionText(const QString& robot, const ScannerCorrection& more) {
    if (more.range != 0.0) {
        return (more.range < 0.0
                    ? ScannerTexts::tr("%1: its 3D scanner measures %2 too far. Correct that?")
                    : ScannerTexts::tr("%1: its 3D scanner measures %2 too short. Correct that?"))
            .arg(robot, centimetres(more.range));
    }
    if (more.clock != 0.0) {
        const QString off = numberText(1e3 * std::abs(more.clock), 0) + QStringLiteral(" ms");
        return (more.clock < 0.0
                    ? ScannerTexts::tr(
                          "%1: the clock of its 3D scanner is %2 ahead of its odometry's. Correct that?")
                    : ScannerTexts::tr(
                          "%1: the clock of its 3D scanner is %2 behind its odometry's. Correct that?"))
            .arg(robot, off);
    }
    if (more.roll == 0.0 && more.pitch == 0.0) {
        return ScannerTexts::tr("%1: its 3D scanner is not mounted as described, but %2. Correct that?")
            .arg(robot, mountText(more));
    }
    return ScannerTexts::tr(
               "%1: its 3D scanner leans, %2 to the %3 and %4 %5, against where it is said to sit. Correct "
               "that?")
        .arg(robot, angle(more.roll), more.roll > 0.0 ? ScannerTexts::tr("right") : ScannerTexts::tr("left"),
             angle(more.pitch), more.pitch > 0.0 ? ScannerTexts::tr("ahead") : ScannerTexts::tr("back"));
}

}  // namespace leitstand
