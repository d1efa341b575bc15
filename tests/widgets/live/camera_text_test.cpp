#include "widgets/models/camera/camera_text.h"

#include <algorithm>

#include <gtest/gtest.h>
#include <QLocale>

#include "core/event/stream_role.h"

namespace leitstand {
namespace {

class CameraWords : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
};

TEST_F(CameraWords, SayWhereACameraLooksAndWhichKeysTurnIt) {
    PanWords words;
    words.pan = degrees(-14.2);
    words.tilt = degrees(5);
    words.keys = QStringLiteral("Q E");
    words.recentreKey = QStringLiteral("C");
    EXPECT_EQ(panText(words).toStdString(), "pan 14° right · 5° down · Q E turn · C re-centres");
    EXPECT_EQ(shortPanText(words).toStdString(), "pan 14° right · 5° down");
    words.pan = degrees(30);
    words.tilt = degrees(-0.3);
    EXPECT_EQ(shortPanText(words).toStdString(), "pan 30° left");
    words.pan = 0.0;
    EXPECT_EQ(shortPanText(words).toStdString(), "pan 0°");
}

TEST_F(CameraWords, GrantsGoBeforeKeys) {
    PanWords words;
    words.pan = 0.0;
    words.keys = QStringLiteral("Q E");
    words.waiting = true;
    EXPECT_EQ(panText(words).toStdString(), "pan 0° · asking for the cameras");
    words.heldBy = QStringLiteral("The van");
    EXPECT_EQ(panText(words).toStdString(), "pan 0° · The van turns the cameras");
    EXPECT_EQ(shortPanText(words).toStdString(), "pan 0° · The van turns the cameras");
}

TEST_F(CameraWords, OnlyCamerasThatMeasureSayDegreesCelsius) {
    StreamDescription stream;
    EXPECT_EQ(cameraTitle(nullptr).toStdString(), "No camera");
    stream.role = StreamRole::Thermal;
    stream.sensor = "ir";
    EXPECT_EQ(cameraTitle(&stream).toStdString(), "Infrared °C");
    stream.thermal.measured = false;
    EXPECT_EQ(cameraTitle(&stream).toStdString(), "Infrared");
    stream.role = StreamRole::Picture;
    stream.sensor = "left";
    EXPECT_EQ(cameraTitle(&stream).toStdString(), "Left camera");
    stream.sensor = "mast";
    EXPECT_EQ(cameraTitle(&stream).toStdString(), "mast");
}

TEST_F(CameraWords, APanoramaHasAheadInTheMiddleAndBehindAtItsEnds) {
    const auto ticks = azimuthTicks({720, 150});
    const auto placeOf = [&](const char* text) {
        const auto found = std::find_if(ticks.begin(), ticks.end(), [&](const AzimuthTick& one) {
            return one.text == QLatin1String(text);
        });
        return found == ticks.end() ? -1.0 : found->place;
    };
    EXPECT_NEAR(placeOf("ahead"), 0.5, 1e-9);
    EXPECT_EQ(ticks.size(), 13U);
    int left = 0;
    for (const AzimuthTick& tick : ticks) left += tick.place < 0.5 && tick.place > 0.0 ? 1 : 0;
    EXPECT_EQ(left, 5);
    EXPECT_TRUE(azimuthTicks({}).empty());
}

}  // namespace
}  // namespace leitstand
