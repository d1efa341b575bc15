#include <algorithm>
#include <cmath>
#include <filesystem>

#include <QApplication>
#include <QLabel>
#include <QMouseEvent>
#include <QTest>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/services/station/cameras/station_cameras.h"
#include "app/window/commands/command_table.h"
#include "app/window/panes/camera/camera_feature.h"
#include "core/base/pose.h"
#include "tests/app/live/live_page.h"
#include "widgets/camera/camera_pane.h"

namespace leitstand::test {
namespace {

class LiveCameras : public LivePage {
protected:
    [[nodiscard]] PanTiltAngles angles(const char* sensor = "left") const {
        const auto turn = station().cameras().turning().view("kurt3d", sensor);
        return turn && turn->now ? *turn->now : PanTiltAngles{NAN, NAN};
    }
    [[nodiscard]] CameraFeature& cameras() const { return *m_window->findChild<CameraFeature*>(); }
    [[nodiscard]] CameraPane& large() const { return *m_window->findChild<CameraPane*>("cameraPane"); }
    [[nodiscard]] ShownPicturePtr shown(CameraPlace place = CameraPlace::Large) const {
        return cameras().views().newest(place);
    }
    [[nodiscard]] CameraPane& small() const { return *m_window->findChild<CameraPane*>("rightPane"); }
    /// What is painted of the small picture.
    [[nodiscard]] QImage painted() const {
        return small().grab(small().pictureArea().toAlignedRect()).toImage();
    }
    /// How far the colours of @p picture are from greys, on average.
    [[nodiscard]] static double colourOf(const QImage& picture) {
        double sum = 0.0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor pixel = picture.pixelColor(x, y);
                sum += std::max({pixel.red(), pixel.green(), pixel.blue()}) -
                       std::min({pixel.red(), pixel.green(), pixel.blue()});
            }
        }
        return sum / std::max(1, picture.width() * picture.height());
    }
    [[nodiscard]] static double lightOf(const QImage& picture) {
        return QImage(picture)
            .scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
            .pixelColor(0, 0)
            .lightnessF();
    }
    void expectInfraredAsItsCommandsSay() {
        const auto command = [this](const char* id) { m_window->commands().trigger(QLatin1String(id)); };
        ASSERT_TRUE(soon([&] { return colourOf(painted()) > 30.0; }))
            << "iron colours: of the infrared camera";
        command("ir.greyHot");
        EXPECT_TRUE(soon([&] { return colourOf(painted()) < 8.0; })) << colourOf(painted());
        const double hotIsWhite = lightOf(painted());
        command("ir.greyCold");
        EXPECT_TRUE(soon([&] { return lightOf(painted()) > hotIsWhite + 0.3; })) << "what is cool is white";
        const QImage fixed = painted();
        command("ir.autoRange");
        EXPECT_TRUE(soon([&] { return std::abs(lightOf(painted()) - lightOf(fixed)) > 0.05; }))
            << "colours follow the picture";
        command("ir.autoRange");
        command("ir.iron");
        EXPECT_TRUE(soon([&] { return colourOf(painted()) > 30.0; }));
    }
    /// Takes hold of the middle of the large picture and pulls it to the right by a tenth of its width.
    void drag() {
        const QRectF area = large().pictureArea();
        const QPoint from = area.center().toPoint();
        QTest::mousePress(&large(), Qt::LeftButton, {}, from);
        for (const double share : {0.02, 0.05, 0.1}) {
            const QPointF at(from.x() + share * area.width(), from.y());
            QMouseEvent move(QEvent::MouseMove, at, at, Qt::NoButton, Qt::LeftButton, {});
            QApplication::sendEvent(&large(), &move);
        }
        QTest::mouseRelease(&large(), Qt::LeftButton);
    }
};

TEST_F(LiveCameras, OfTheRobotTurnByKeysAndDragAndComeBack) {
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    ASSERT_TRUE(soon([&] { return std::isfinite(angles().pan); }));
    // Nobody drives: the grant to turn cameras is asked for by the first key.
    QTest::keyPress(m_window.get(), Qt::Key_Q);
    EXPECT_TRUE(soon([&] { return angles().pan > 0.3; })) << "while it is held";
    QTest::keyRelease(m_window.get(), Qt::Key_Q);
    QTest::keyPress(m_window.get(), Qt::Key_PageDown);
    EXPECT_TRUE(soon([&] { return angles().tilt > 0.2; }));
    lookAt("turned");
    QTest::keyRelease(m_window.get(), Qt::Key_PageDown);
    EXPECT_NEAR(angles("right").pan, 0.0, 0.02) << "the other unit";
    EXPECT_FALSE(m_window->driving()) << "no key of these drives";
    press(Qt::Key_C);
    ASSERT_TRUE(soon([&] { return std::abs(angles().pan) < 0.01 && std::abs(angles().tilt) < 0.01; }));
    drag();
    EXPECT_FALSE(m_window->driving()) << "a drag is no click";
    // 60 degrees across: a tenth of the width is about 6.6 degrees in the middle.
    EXPECT_TRUE(soon([&] { return std::abs(angles().pan - std::atan(0.2 * std::tan(degrees(30)))) < 0.02; }));
    EXPECT_NEAR(angles().tilt, 0.0, 0.01);
    cameras().turnTo(degrees(170), 0.0);
    EXPECT_TRUE(soon([&] { return std::abs(angles().pan - degrees(100)) < 0.01; })) << "its limit";
    QTest::mouseClick(&large(), Qt::LeftButton);
    EXPECT_TRUE(m_window->driving());
}

TEST_F(LiveCameras, AreSeenInTheDarkKeptUnwrappedAndSwitched) {
    namespace fs = std::filesystem;
    ASSERT_TRUE(soon([&] { return m_window->missing().isEmpty(); })) << m_window->missing().toStdString();
    EXPECT_EQ(shown()->contrast, ContrastHelp::Off);
    press(Qt::Key_L);
    EXPECT_TRUE(soon([&] { return shown()->contrast == ContrastHelp::Gentle; }));
    press(Qt::Key_L);
    EXPECT_TRUE(soon([&] { return shown()->contrast == ContrastHelp::Strong; }));
    lookAt("contrast");
    press(Qt::Key_P);
    const fs::path folder = fs::path(m_folder.path().toStdString()) / "mission" / "snapshots";
    const auto* word = m_window->findChild<QLabel*>("word");
    ASSERT_TRUE(soon([&] { return word->text().contains("Snapshot kept"); })) << word->text().toStdString();
    int kept = 0;
    for (const auto& entry : fs::directory_iterator(folder)) {
        const QImage picture(QString::fromStdString(entry.path().string()));
        EXPECT_EQ(picture.width(), 320);
        EXPECT_TRUE(picture.text("Title").contains("Left camera"));
        EXPECT_FALSE(picture.text("Pose in odom [x y z qx qy qz qw, m]").isEmpty());
        ++kept;
    }
    EXPECT_EQ(kept, 1);
    press(Qt::Key_L);
    EXPECT_TRUE(soon([&] { return shown()->contrast == ContrastHelp::Off; }));
    const std::string before = cameras().views().sensor(CameraPlace::Small);
    press(Qt::Key_I);
    EXPECT_NE(cameras().views().sensor(CameraPlace::Small), before);
    for (int i = 0; i < 4 && cameras().views().sensor(CameraPlace::Small) != "ir"; ++i) press(Qt::Key_I);
    ASSERT_EQ(cameras().views().sensor(CameraPlace::Small), "ir");
    expectInfraredAsItsCommandsSay();
    press(Qt::Key_2);
    ASSERT_TRUE(soon([&] { return m_window->selected() == "crawler" && shown() && shown()->panorama; }));
    lookAt("panorama");
    press(Qt::Key_U);
    EXPECT_TRUE(soon([&] { return !shown()->panorama; }));
    lookAt("omni");
}

}  // namespace
}  // namespace leitstand::test
