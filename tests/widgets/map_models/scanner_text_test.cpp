#include "widgets/models/map/scanner_text.h"

#include <gtest/gtest.h>
#include <QLocale>

namespace leitstand::test {
namespace {

TEST(ScannerText, AsksAboutEachErrorInTheUnitsOfWhoMountsIt) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    const auto asked = [](const ScannerCorrection& more) {
        return scannerQuestionText(QStringLiteral("Kurt3D"), more).toStdString();
    };
    EXPECT_EQ(asked({-0.021}), "Kurt3D: its 3D scanner measures 2.1 cm too far. Correct that?");
    EXPECT_EQ(asked({0.01}), "Kurt3D: its 3D scanner measures 1.0 cm too short. Correct that?");
    EXPECT_EQ(
        asked({0.0, degrees(-0.4), degrees(0.2)}),
        "Kurt3D: its 3D scanner leans, 0.4° to the left and 0.2° ahead, against where it is said to sit. "
        "Correct that?");
    ScannerCorrection more;
    more.clock = -0.0604;
    EXPECT_EQ(asked(more),
              "Kurt3D: the clock of its 3D scanner is 60 ms ahead of its odometry's. Correct that?");
    more.clock = 0.02;
    EXPECT_EQ(asked(more),
              "Kurt3D: the clock of its 3D scanner is 20 ms behind its odometry's. Correct that?");
    more = {};
    more.x = 0.025;
    more.y = -0.03;
    more.yaw = degrees(0.8);
    EXPECT_EQ(asked(more),
              "Kurt3D: its 3D scanner is not mounted as described, but 2.5 cm farther ahead, 3.0 cm farther "
              "right, turned 0.8° to the left. Correct that?");
    more = {};
    more.yaw = degrees(-1);
    EXPECT_EQ(
        asked(more),
        "Kurt3D: its 3D scanner is not mounted as described, but turned 1.0° to the right. Correct that?");
}

}  // namespace
}  // namespace leitstand::test
