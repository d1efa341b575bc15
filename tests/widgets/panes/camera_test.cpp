#include "widgets/camera/camera_pane.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <QSignalSpy>
#include <QTest>

#include "tests/widgets/panes/shown.h"

namespace leitstand::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr QRgb Plain = qRgb(70, 70, 70);

std::vector<std::string> wordsOf(QWidget& widget) {
    std::vector<std::string> words;
    for (const PaintedText& one : paintedTexts(widget)) words.push_back(one.text.toStdString());
    return words;
}

QImage plain(int width = 320, int height = 240) {
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(Plain);
    return image;
}

std::shared_ptr<const ThermalPicture> body() {
    auto picture = std::make_shared<ThermalPicture>(ThermalPicture{160, 120, {}});
    for (int y = 0; y < 120; ++y) {
        for (int x = 0; x < 160; ++x)
            picture->celsius.push_back(std::hypot(x - 80, y - 60) < 15 ? 33.5F : 19.0F);
    }
    return picture;
}

class Cameras : public testing::TestWithParam<Theme> {
protected:
    void SetUp() override {
        useTheme(GetParam());
        pane.setCamera(robot.face, QStringLiteral("Left camera"));
        pane.setPicture(plain());
        pane.setAge({.arrival = 0.0, .content = 0.0});
    }
    SampleRobot robot = sampleRobot();
    CameraPane pane;
};

TEST_P(Cameras, ShowWhereTheyLookFromAbove) {
    CameraOverlay overlay;
    overlay.turn.pan = degrees(40);
    overlay.turn.tilt = degrees(10);
    overlay.turn.keys = QStringLiteral("Q E PgUp PgDn");
    overlay.turn.recentreKey = QStringLiteral("C");
    overlay.requestedPan = degrees(-20);
    pane.setOverlay(overlay);
    const auto whiteIn = [&](const QRect& part) {
        const QImage picture = pictureOf(pane, {640, 480}, QStringLiteral("camera-turned"));
        int white = 0;
        for (int y = part.top(); y <= part.bottom(); ++y) {
            for (int x = part.left(); x <= part.right(); ++x)
                white += qGray(picture.pixel(x, y)) > 90 ? 1 : 0;
        }
        return white;
    };
    const QRect leftHalf(8, 418, 24, 30), rightHalf(40, 418, 24, 30);
    EXPECT_GT(whiteIn(leftHalf), 2 * whiteIn(rightHalf)) << "the wedge turns with the camera";
    EXPECT_THAT(wordsOf(pane), Contains("pan 40° left · 10° down · Q E PgUp PgDn turn · C re-centres"));
    EXPECT_EQ(textFaults(pane).join("; ").toStdString(), "");
    (void)pictureOf(pane, {240, 180}, QStringLiteral("camera-turned-small"));
    EXPECT_THAT(wordsOf(pane), Not(Contains(HasSubstr("pan"))));
    (void)pictureOf(pane, {640, 480}, QStringLiteral("camera-turned-2x"), 2.0);
}

TEST_P(Cameras, TheHorizonLeansAndRisesAsTheRobotDoes) {
    /// Mean height of the horizon's left and right part [px from the top].
    const auto horizon = [&](double roll, double pitch) {
        CameraOverlay overlay;
        overlay.roll = roll;
        overlay.pitch = pitch;
        pane.setOverlay(overlay);
        const QImage picture = pictureOf(pane, {640, 480}, {});
        const QColor ink = coloursOf(Theme::Dark).select;
        std::array<double, 2> sum{}, count{};
        for (int y = 40; y < 440; ++y) {
            for (int x = 60; x < 580; ++x) {
                const QColor found = picture.pixelColor(x, y);
                const bool line = std::abs(found.red() - ink.red()) + std::abs(found.green() - ink.green()) +
                                      std::abs(found.blue() - ink.blue()) <
                                  30;
                if (!line) continue;
                sum[x < 320 ? 0 : 1] += y;
                count[x < 320 ? 0 : 1] += 1.0;
            }
        }
        EXPECT_GT(std::min(count[0], count[1]), 20.0) << "both parts of it are there";
        return std::pair(sum[0] / count[0], sum[1] / count[1]);
    };
    const auto level = horizon(0.0, 0.0), right = horizon(degrees(8), 0.0), left = horizon(degrees(-8), 0.0),
               down = horizon(0.0, degrees(8)), up = horizon(0.0, degrees(-8));
    EXPECT_NEAR(level.first, level.second, 1.5);
    EXPECT_GT(right.first, right.second + 20.0) << "its right side is down: the world leans to the left";
    EXPECT_GT(left.second, left.first + 20.0);
    EXPECT_LT(down.first, level.first - 20.0) << "nose down: the horizon is higher in the picture";
    EXPECT_GT(up.first, level.first + 20.0);
}

TEST_P(Cameras, SayWhatWasDoneToTheirPictures) {
    EXPECT_THAT(wordsOf(pane), Not(Contains(HasSubstr("contrast"))));
    CameraOverlay overlay;
    overlay.mode = modeLabelOf(robot.view, robot.reported.mode);
    overlay.notes = {QStringLiteral("contrast raised strongly")};
    pane.setOverlay(overlay);
    (void)pictureOf(pane, {640, 480}, QStringLiteral("camera-contrast"));
    EXPECT_THAT(wordsOf(pane), Contains("contrast raised strongly"));
    EXPECT_EQ(textFaults(pane).join("; ").toStdString(), "");
}

TEST_P(Cameras, PanoramasHaveDirectionsAndLeaveRoomBelow) {
    const PanoramaShape shape{720, 150};
    pane.setPicture(plain(720, 150));
    pane.setPanorama(shape);
    CameraOverlay overlay;
    overlay.mode = modeLabelOf(robot.view, robot.reported.mode);
    overlay.ring = proximityRing(*robot.view.around, boxAround(robot.description.footprint), {0.2, 0, 0});
    pane.setOverlay(overlay);
    (void)pictureOf(pane, {780, 560}, QStringLiteral("camera-panorama"));
    (void)pictureOf(pane, {780, 560}, QStringLiteral("camera-panorama-2x"), 2.0);
    EXPECT_LT(pane.pictureArea().bottom(), 250);
    EXPECT_GT(pane.pictureArea().top(), 0);
    for (const char* word : {"ahead", "left 90°", "right 90°", "behind"})
        EXPECT_THAT(wordsOf(pane), Contains(word));
    EXPECT_EQ(textFaults(pane).join("; ").toStdString(), "");
    (void)pictureOf(pane, {240, 180}, QStringLiteral("camera-panorama-small"));
    EXPECT_EQ(textFaults(pane).join("; ").toStdString(), "");
    pane.setPicture(plain());
    pane.setPanorama({});
    EXPECT_THAT(wordsOf(pane), Not(Contains("behind")));
}

TEST_P(Cameras, MarkTheFrontInRawOmniPictures) {
    pane.setPicture(plain(320, 320));
    pane.setFront(QPointF(0.5, 0.12));
    const QImage picture = pictureOf(pane, {480, 480}, QStringLiteral("camera-omni-raw"));
    EXPECT_GT(countOf(picture.copy(220, 40, 40, 50), coloursOf(Theme::Dark).select, 20), 40);
    EXPECT_THAT(wordsOf(pane), Contains("ahead"));
}

TEST_P(Cameras, InfraredHasALegendABodyAndTheValueUnderThePointer) {
    pane.setCamera(robot.face, QStringLiteral("Infrared °C"));
    const auto picture = body();
    for (const auto palette : {ThermalPalette::Iron, ThermalPalette::GreyHot, ThermalPalette::GreyCold}) {
        pane.setThermal(picture, {}, palette);
        pane.setHeat(findHeat(*picture, {}));
        pane.setAge({.arrival = 0.0, .content = 0.0});
        pane.resize(320, 240);
        QMouseEvent move(QEvent::MouseMove, QPointF(160, 120), QPointF(160, 120), Qt::NoButton, {}, {});
        QApplication::sendEvent(&pane, &move);
        (void)pictureOf(pane, {320, 240},
                        QStringLiteral("infrared") + QString::number(static_cast<int>(palette)));
        EXPECT_THAT(wordsOf(pane), Contains(HasSubstr("40 °C")));
        EXPECT_THAT(wordsOf(pane), Contains("15"));
        EXPECT_THAT(wordsOf(pane), Contains("33.5 °C")) << "under the pointer";
        EXPECT_THAT(wordsOf(pane), Contains(HasSubstr("person?")));
    }
}

TEST_P(Cameras, WordsAboutHeatNeverLieOnEachOther) {
    pane.setCamera(robot.face, QStringLiteral("Infrared °C"));
    pane.setThermal(body());
    std::vector<HeatBlob> blobs;
    for (const auto& [x, y] : {std::pair(20, 60), std::pair(27, 54), std::pair(33, 60), std::pair(78, 58),
                               std::pair(90, 88), std::pair(120, 62), std::pair(3, 3)}) {
        HeatBlob blob;
        blob.kind = HeatBlob::Kind::Body;
        blob.left = x, blob.top = y, blob.right = x + 4, blob.bottom = y + 4;
        blob.mean = 34.0 + 0.1 * static_cast<double>(blobs.size());
        blobs.push_back(blob);
    }
    pane.setHeat(blobs);
    pane.setAge({.arrival = 0.0, .content = 0.0});
    for (const QSize size : {QSize(240, 200), QSize(320, 240), QSize(640, 480)}) {
        (void)pictureOf(pane, size, QStringLiteral("infrared-bodies-%1").arg(size.width()));
        EXPECT_EQ(textFaults(pane).join("; ").toStdString(), "") << size.width();
        EXPECT_THAT(wordsOf(pane), Contains(HasSubstr("person?")));
    }
    EXPECT_THAT(wordsOf(pane), Not(Contains("34.0 °C person?"))) << "hand, head, hand: one body";
    EXPECT_THAT(wordsOf(pane), Contains("34.2 °C person?"));
}

TEST_P(Cameras, WordsAboutHeatKeepOffTheScaleInEverySize) {
    pane.setCamera(robot.face, QStringLiteral("Infrared °C"));
    pane.setThermal(body());
    pane.setAge({.arrival = 0.0, .content = 0.0});
    int words = 0;
    for (const QSize size : {QSize(150, 120), QSize(190, 150), QSize(240, 200), QSize(320, 240)}) {
        for (const int x : {60, 100, 130, 150}) {
            HeatBlob blob;
            blob.kind = HeatBlob::Kind::Body;
            blob.left = x, blob.top = 50, blob.right = x + 8, blob.bottom = 80;
            blob.mean = 34.0;
            pane.setHeat({blob});
            (void)pictureOf(pane, size, QStringLiteral("infrared-edge-%1-%2").arg(size.width()).arg(x));
            for (const PaintedText& one : paintedTexts(pane)) {
                if (!one.text.contains(QStringLiteral("person?"))) continue;
                ++words;
                EXPECT_LE(one.box.right(), pane.pictureArea().right() - 80.0) << size.width() << " " << x;
            }
        }
    }
    EXPECT_GT(words, 8);
}

/// How much of @p pane's picture the badge of its mode covers, by the colour of that: 0 to 1.
double coveredBy(CameraPane& pane, const QSize& size, const QColor& surface) {
    const QImage picture = pictureOf(pane, size, QStringLiteral("camera-badge-%1").arg(size.width()));
    const QRect area = pane.pictureArea().toRect() & pane.rect();
    int least = area.right(), most = area.left(), top = area.bottom(), bottom = area.top();
    for (int y = area.top(); y <= area.bottom(); ++y) {
        for (int x = area.left(); x <= area.right(); ++x) {
            if (picture.pixelColor(x, y) != surface) continue;
            least = std::min(least, x), most = std::max(most, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    }
    if (most < least) return 0.0;
    return double(most - least + 1) * (bottom - top + 1) / (double(area.width()) * area.height());
}

TEST_P(Cameras, TheModeCoversAFifthOfASmallPictureAtMost) {
    CameraOverlay overlay;
    overlay.mode = ModeLabel{ModeKind::Autonomous, "VICTIM APPROACH", {}, "APPROACH"};
    pane.setOverlay(overlay);
    const QColor surface = coloursOf(Theme::Dark).autonomous;
    for (const QSize size :
         {QSize(90, 70), QSize(120, 90), QSize(160, 90), QSize(160, 120), QSize(240, 180), QSize(640, 480)}) {
        const double covered = coveredBy(pane, size, surface);
        EXPECT_GT(covered, 0.0) << size.width() << ": it is there";
        EXPECT_LE(covered, 0.2) << size.width();
        const auto words = wordsOf(pane);
        EXPECT_THAT(words, testing::AnyOf(Contains("VICTIM APPROACH"), Contains("APPROACH"), Contains("A")));
    }
    (void)pictureOf(pane, {640, 480}, {});
    EXPECT_THAT(wordsOf(pane), Contains("VICTIM APPROACH"));
}

TEST_P(Cameras, TheRingKeepsOffWordsInEverySize) {
    CameraOverlay overlay;
    overlay.mode = modeLabelOf(robot.view, robot.reported.mode);
    overlay.ring = proximityRing(*robot.view.around, boxAround(robot.description.footprint), {0.2, 0, 0});
    for (Proximity& part : overlay.ring) part.nearness = Nearness::Near, part.distance = 0.2;
    overlay.turn.pan = 0.0;
    overlay.turn.keys = QStringLiteral("Q E PgUp PgDn");
    pane.setOverlay(overlay);
    for (const QSize size : {QSize(210, 240), QSize(360, 270), QSize(512, 270), QSize(640, 480)}) {
        (void)pictureOf(pane, size, QStringLiteral("camera-ring-%1").arg(size.width()));
        EXPECT_EQ(textFaults(pane).join("; ").toStdString(), "") << size.width();
    }
}

TEST_P(Cameras, AnEmptyPaneIsCalm) {
    CameraPane empty;
    empty.setCamera(robot.face, QStringLiteral("No camera"));
    const auto amber = [&] {
        return countOf(pictureOf(empty, {320, 240}, {}), coloursOf(GetParam()).attention, 40);
    };
    EXPECT_GT(amber(), 20);
    empty.setVacant(true);
    EXPECT_EQ(amber(), 0);
    EXPECT_THAT(wordsOf(empty), Not(Contains(HasSubstr("no data"))));
}

TEST_P(Cameras, ADoubleClickPointsOnce) {
    pane.resize(640, 480);
    QSignalSpy pointed(&pane, &CameraPane::pointedAt), clicked(&pane, &CameraPane::pictureClicked);
    const auto clickTwice = [this](Qt::KeyboardModifiers keys) {
        QTest::mouseClick(&pane, Qt::LeftButton, keys, {320, 240});
        QTest::mouseDClick(&pane, Qt::LeftButton, keys, {320, 240});
        QTest::mouseRelease(&pane, Qt::LeftButton, keys, {320, 240});
    };
    clickTwice(Qt::ShiftModifier);
    EXPECT_EQ(pointed.size(), 1);
    // Armed: the first click points, and whoever armed it lets go.
    pane.setPointing(true);
    QObject::connect(&pane, &CameraPane::pointedAt, &pane, [this] { pane.setPointing(false); });
    clickTwice({});
    EXPECT_EQ(pointed.size(), 2);
    EXPECT_TRUE(clicked.isEmpty()) << "and nothing is driven to";
}

TEST_P(Cameras, ADragIsNoClick) {
    pane.resize(640, 480);
    QSignalSpy clicked(&pane, &CameraPane::pictureClicked), dragged(&pane, &CameraPane::pictureDragged);
    const auto drag = [&] {
        QTest::mousePress(&pane, Qt::LeftButton, {}, {320, 240});
        for (const int x : {330, 360, 480}) {
            QMouseEvent move(QEvent::MouseMove, QPointF(x, 240), QPointF(x, 240), Qt::NoButton,
                             Qt::LeftButton, {});
            QApplication::sendEvent(&pane, &move);
        }
        QTest::mouseRelease(&pane, Qt::LeftButton, {}, {480, 240});
    };
    pane.setTurnable(true);
    drag();
    EXPECT_TRUE(clicked.isEmpty());
    ASSERT_GE(dragged.size(), 2);
    EXPECT_TRUE(dragged.first()[2].toBool());
    EXPECT_FALSE(dragged.last()[2].toBool());
    EXPECT_NEAR(dragged.last()[0].toPointF().x(), 0.5, 1e-9);
    EXPECT_NEAR(dragged.last()[1].toPointF().x(), 0.75, 1e-9);
    QTest::mouseClick(&pane, Qt::LeftButton, {}, {320, 240});
    EXPECT_EQ(clicked.size(), 1);
    const auto before = dragged.size();
    pane.setTurnable(false);
    drag();
    EXPECT_EQ(dragged.size(), before);
}

INSTANTIATE_TEST_SUITE_P(Themes, Cameras, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& info) { return info.param == Theme::Dark ? "Dark" : "Light"; });

}  // namespace
}  // namespace leitstand::test
