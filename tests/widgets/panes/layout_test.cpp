#include <iostream>

#include <gtest/gtest.h>
#include <QBoxLayout>
#include <QElapsedTimer>
#include <QTranslator>

#include "core/event/stream_role.h"
#include "tests/widgets/panes/shown.h"
#include "widgets/camera/camera_pane.h"
#include "widgets/drive/drive_strip.h"
#include "widgets/drive/stop_button.h"
#include "widgets/robots/robot_bar.h"
#include "widgets/virtual_scan/virtual_scan_pane.h"

namespace leitstand::test {
namespace {

/// A grey corridor as a camera may see it.
QImage cameraPicture() {
    QImage image(640, 480, QImage::Format_RGB32);
    image.fill(QColor("#4a5058"));
    QPainter painter(&image);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor("#30353c"));
    painter.drawPolygon(QPolygon({{0, 480}, {240, 290}, {400, 290}, {640, 480}}));
    painter.setBrush(QColor("#b8c0c8"));
    painter.drawPolygon(QPolygon({{0, 0}, {240, 180}, {400, 180}, {640, 0}}));
    painter.setBrush(QColor("#7d838c"));
    painter.drawRect(240, 180, 160, 110);
    painter.setBrush(QColor("#8a5a3a"));
    painter.drawRect(430, 250, 90, 140);
    return image;
}

std::shared_ptr<const ThermalPicture> thermalPicture() {
    auto picture = std::make_shared<ThermalPicture>();
    picture->width = 160;
    picture->height = 120;
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x) {
            const double d = std::hypot((x - 90) / 22.0, (y - 62) / 17.0);
            picture->celsius.push_back(static_cast<float>(19.0 + 15.6 * std::exp(-d * d)));
        }
    }
    return picture;
}

CameraOverlay overlayOf(const SampleRobot& robot) {
    CameraOverlay overlay;
    overlay.mode = modeLabelOf(robot.view, robot.reported.mode);
    overlay.roll = degrees(6);
    overlay.pitch = degrees(-3);
    overlay.turn.pan = degrees(-14);
    overlay.turn.tilt = 0.0;
    overlay.turn.keys = QStringLiteral("Q E PgUp PgDn");
    overlay.turn.recentreKey = QStringLiteral("C");
    overlay.ring =
        proximityRing(*robot.view.around, boxAround(robot.description.footprint), robot.view.drive.velocity);
    return overlay;
}

/// The live part of the drive layout, as the window puts it together.
class DriveLayout final : public QWidget {
public:
    DriveLayout(const SampleRobot& kurt, const SampleRobot& crawler) {
        auto* all = new QVBoxLayout(this);
        all->setContentsMargins(0, 0, 0, 0);
        all->setSpacing(0);
        auto* top = new QHBoxLayout;
        top->setContentsMargins(12, 6, 12, 6);
        top->addWidget(&bar, 1);
        top->addStretch(1);
        top->addWidget(&stop);
        all->addLayout(top);
        auto* middle = new QHBoxLayout;
        middle->setSpacing(1);
        middle->addWidget(&camera, 5);
        auto* right = new QVBoxLayout;
        right->setSpacing(1);
        right->addWidget(&scan, 3);
        right->addWidget(&infrared, 2);
        middle->addLayout(right, 3);
        all->addLayout(middle, 1);
        auto* bottom = new QHBoxLayout;
        bottom->addWidget(&strip, 3);
        bottom->addStretch(1);
        all->addLayout(bottom);

        bar.show({robotChipOf(kurt.face, kurt.view, kurt.reported, at(0)),
                  robotChipOf(crawler.face, crawler.view, crawler.reported, at(0))},
                 {stopLineOf(kurt.face, kurt.view), stopLineOf(crawler.face, crawler.view)}, kurt.face.name);
        camera.setCamera(kurt.face, QStringLiteral("Left camera"));
        camera.setPicture(cameraPicture());
        camera.setAge({.arrival = 0.064, .content = 0.064}, QStringLiteral("full speed"));
        camera.setOverlay(overlayOf(kurt));
        scan.setRobot(kurt.face, kurt.description.footprint);
        scan.show(kurt.view.around, kurt.view.drive.velocity, 0.1);
        infrared.setCamera(kurt.face, QStringLiteral("Infrared"));
        infrared.setThermal(thermalPicture());
        HeatBlob body;
        body.kind = HeatBlob::Kind::Body;
        body.left = 72, body.top = 48, body.right = 108, body.bottom = 76;
        body.mean = 34.6;
        infrared.setHeat({body});
        infrared.setAge({.arrival = 0.098, .content = 0.098});
        strip.show(driveStateOf(kurt));
    }

    RobotBar bar;
    StopButton stop;
    CameraPane camera, infrared;
    VirtualScanPane scan;
    DriveStrip strip;
};

SampleRobot crawler() {
    SampleRobot robot = sampleRobot("C", "Crawler", 1);
    robot.view.link.state = LinkState::Degraded;
    robot.view.link.roundTrip->median = 0.148;
    robot.view.link.streams[0].lossRatio = 0.04;
    robot.view.link.reasons = {{LinkReason::Kind::Loss, 0.04, StreamRole::Picture, "omni", "/omni"}};
    setMode(robot, "stopped");
    return robot;
}

class DriveLayouts : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override { useTheme(GetParam()); }
};

TEST_P(DriveLayouts, AreCalmWhenAllIsWell) {
    const SampleRobot kurt = sampleRobot();
    SampleRobot other = sampleRobot("C", "Crawler", 1);
    DriveLayout layout(kurt, other);
    layout.camera.setOverlay({});
    layout.scan.show(corridor(3.0), {}, 0.1);
    DriveState state = driveStateOf(kurt);
    state.nearest.tone = Tone::Normal;
    layout.strip.show(state);
    const QImage picture = pictureOf(layout, {1280, 800}, "calm");
    EXPECT_LT(countOf(picture.copy(0, 600, 1280, 200), coloursOf(GetParam()).attention, 4), 8);
    EXPECT_LT(countOf(picture.copy(0, 0, 800, 40), coloursOf(GetParam()).attention, 4), 8);
    EXPECT_EQ(textFaults(layout).join("; ").toStdString(), "");
}

TEST_P(DriveLayouts, ClipNothingFromTheSmallestToTheLargestScreen) {
    const SampleRobot kurt = sampleRobot();
    const SampleRobot other = crawler();
    for (const auto& [size, scale, name] : {std::tuple(QSize(1280, 800), 1.0, "layout-1280"),
                                            std::tuple(QSize(1920, 1080), 2.0, "layout-3840")}) {
        DriveLayout layout(kurt, other);
        const QImage picture = pictureOf(layout, size, QString::fromLatin1(name), scale);
        EXPECT_EQ(textFaults(layout).join("; ").toStdString(), "") << name;
        EXPECT_GT(countOf(picture, coloursOf(GetParam()).stop, 2), 1000) << name;
    }
}

TEST_P(DriveLayouts, SayWhatIsLostAndStopped) {
    SampleRobot kurt = sampleRobot();
    setStop(kurt, true, true);
    SampleRobot other = sampleRobot("C", "Crawler", 1);
    other.view.link.state = LinkState::Lost;
    other.view.link.silence = 4.2;
    setStop(other, false, false);
    other.view.stop.unanswered = std::chrono::milliseconds(4200);
    DriveLayout layout(kurt, other);
    layout.camera.setAge({.arrival = 4.3, .content = 4.3}, QStringLiteral("stopped"));
    layout.scan.show(kurt.view.around, {}, 1.6);
    layout.infrared.setAge({.arrival = 0.1, .content = 2.4});
    (void)pictureOf(layout, {1280, 800}, "stopped");
    EXPECT_EQ(textFaults(layout).join("; ").toStdString(), "");
    layout.strip.show(driveStateOf(other));
    (void)pictureOf(layout, {1280, 800}, "lost");
    EXPECT_EQ(textFaults(layout).join("; ").toStdString(), "");
}

/// A language whose words are half as long again.
class LongLanguage final : public QTranslator {
public:
    [[nodiscard]] QString translate(const char* /*context*/, const char* text, const char* /*comment*/,
                                    int /*count*/) const override {
        const QString words = QString::fromUtf8(text);
        return words.contains(QLatin1Char('%')) || words.size() < 3 ? words
                                                                    : words + words.right(words.size() / 2);
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

TEST(DriveLayoutWords, StayApartInALanguageOfLongWords) {
    useTheme(Theme::Dark);
    LongLanguage language;
    QCoreApplication::installTranslator(&language);
    SampleRobot kurt = sampleRobot();
    kurt.view.drive.needsNeutral = true;
    DriveLayout layout(kurt, crawler());
    (void)pictureOf(layout, {1280, 800}, "long-words");
    for (const QString& fault : textFaults(layout)) {
        EXPECT_TRUE(fault.endsWith(QStringLiteral("is cut"))) << fault.toStdString();  // words may give way
    }
    QCoreApplication::removeTranslator(&language);
}

TEST(DriveLayoutLatency, IsPaintedWellWithinAFrame) {
    useTheme(Theme::Dark);
    DriveLayout layout(sampleRobot(), crawler());
    for (const auto& [size, scale] : {std::pair(QSize(1280, 800), 1.0), std::pair(QSize(1920, 1080), 2.0)}) {
        (void)pictureOf(layout, size, {}, scale);
        std::cout << scale * size.width() << " x " << scale * size.height() << ':';
        double all = 0.0;
        for (QWidget* pane :
             {static_cast<QWidget*>(&layout.camera), static_cast<QWidget*>(&layout.scan),
              static_cast<QWidget*>(&layout.infrared), static_cast<QWidget*>(&layout.strip)}) {
            QImage picture((QSizeF(pane->size()) * scale).toSize(), QImage::Format_RGB32);
            picture.setDevicePixelRatio(scale);
            QElapsedTimer timer;
            timer.start();
            constexpr int Frames = 10;
            for (int i = 0; i < Frames; ++i) pane->render(&picture);
            const double milliseconds = static_cast<double>(timer.nsecsElapsed()) / 1e6 / Frames;
            std::cout << ' ' << pane->metaObject()->className() << ' ' << milliseconds << " ms";
            all += milliseconds;
        }
        std::cout << '\n';
        EXPECT_LT(all, 100.0 * scale);
    }
}

INSTANTIATE_TEST_SUITE_P(Themes, DriveLayouts, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& info) { return info.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
