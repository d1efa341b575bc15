#include "widgets/models/live/readings/reading_rows.h"

#include <limits>

#include <gtest/gtest.h>
#include <QLocale>

#include "core/base/unknown.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/mission/state/robot_state.h"
#include "widgets/models/live/readings/reading_text.h"

namespace leitstand::test {
namespace {

class ReadingRows : public testing::Test {
protected:
    void SetUp() override {
        QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
        StreamDescription air;
        air.role = StreamRole::Reading;
        air.topic = "/air";
        air.readings = {{"temperature", "Air", "°C", 1.0, 0.0, {}, {{}, 45.0, {}, 60.0}},
                        {"variance", "temperature", ""}};
        m_robot.streams.push_back(air);
    }
    void report(double value, double age) {
        Latest<ReadingSample> latest{1, m_now - nanoseconds(age), {{}, {value, Unknown}}};
        m_reported.readings["/air"] = latestPtr(std::move(latest));
    }
    static std::chrono::nanoseconds nanoseconds(double seconds) {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::duration<double>(seconds));
    }
    [[nodiscard]] ReadingRow first() const { return readingRows(m_robot, m_reported, m_now).at(0); }

    const Time m_now{std::chrono::seconds(1'800'000'000)};
    RobotDescription m_robot;
    RobotState m_reported;
};

TEST_F(ReadingRows, SayWhatWasMeasuredAndItsLimits) {
    report(22.46, 0.3);
    EXPECT_EQ(first().title, "Air");
    EXPECT_EQ(first().value, "22.5 °C");
    EXPECT_EQ(first().limits, "≤ 45 / ≤ 60");
    EXPECT_EQ(first().age, "") << "it is of now";
    EXPECT_EQ(first().tone, Tone::Normal);
    EXPECT_EQ(readingRows(m_robot, m_reported, m_now).at(1).value, "–");
}

TEST_F(ReadingRows, StandOutBeyondTheirLimits) {
    report(46.0, 0.3);
    EXPECT_EQ(first().tone, Tone::Attention);
    report(61.0, 0.3);
    EXPECT_EQ(first().tone, Tone::Act);
}

TEST_F(ReadingRows, GrowOldAndPale) {
    report(22.0, 12.4);
    EXPECT_EQ(first().tone, Tone::Muted);
    EXPECT_EQ(first().age, "12 s");
    report(61.0, 12.4);
    EXPECT_EQ(first().tone, Tone::Act) << "the last that was heard is no reason to be calm";
}

TEST_F(ReadingRows, OfWhichNothingCameAreThere) {
    EXPECT_EQ(first().value, "–");
    EXPECT_EQ(first().tone, Tone::Muted);
    EXPECT_EQ(first().age, "");
}

TEST_F(ReadingRows, HaveAsManyDigitsAsAreReadAtAGlance) {
    EXPECT_EQ(readingText(1013.27, "hPa"), "1,013 hPa");
    EXPECT_EQ(readingText(4.256, "V"), "4.26 V");
    EXPECT_EQ(readingText(0.012345, ""), "0.0123");
    EXPECT_EQ(readingText(51.7, "°", 6), "51.700000°");
    EXPECT_EQ(readingText(0.0, "m"), "0.0 m");
    EXPECT_EQ(readingText(-12.26, "°C"), "−12.3 °C");
    EXPECT_EQ(readingText(1e-30, ""), "0.000000000");
    EXPECT_EQ(readingText(std::numeric_limits<double>::infinity(), "m"), "∞ m");
    EXPECT_EQ(readingText(1e200, ""), "1.000E+200");
    EXPECT_EQ(limitsText({10.0, 40.0, {}, {}}), "10 to 40");
    EXPECT_EQ(limitsText({0.125, {}, {}, {}}), "≥ 0.125");
    EXPECT_EQ(limitsText({}), "");
}

}  // namespace
}  // namespace leitstand::test
