#include <limits>

#include <QLocale>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "widgets/models/live/texts/clock_text.h"
#include "widgets/models/live/texts/record_text.h"

namespace leitstand {
namespace {

using std::chrono::milliseconds;
using std::chrono::minutes;
using std::chrono::seconds;
using testing::HasSubstr;

ClockText at(std::chrono::nanoseconds elapsed, std::chrono::nanoseconds limit, bool running = true) {
    MissionClock clock{.running = running, .elapsed = elapsed, .limit = limit};
    if (limit.count() > 0) clock.left = limit - elapsed;
    return clockText(clock);
}

TEST(ClockWords, CountsUpWithoutALengthAndDownWithOne) {
    EXPECT_EQ(at(seconds(439), {}).value, "07:19");
    EXPECT_EQ(at(seconds(439), {}).caption, "time");
    EXPECT_EQ(at(seconds(439), minutes(20)).value, "12:41");
    EXPECT_EQ(at(seconds(439), minutes(20)).caption, "left");
    EXPECT_EQ(at(minutes(62), {}).value, "1:02:00");
    EXPECT_EQ(at(seconds(439), minutes(20)).details, "Mission time 07:19 of 20:00, running");
}

TEST(ClockWords, IsCalmUntilTheLastTwoMinutes) {
    EXPECT_EQ(at(minutes(17), minutes(20)).tone, Tone::Normal);
    EXPECT_EQ(at(seconds(18 * 60 + 1), minutes(20)).tone, Tone::Attention);
    EXPECT_EQ(at(milliseconds(1'199'500), minutes(20)).value, "00:01") << "zero is the end";
    EXPECT_EQ(at(minutes(20), minutes(20)),
              (ClockText{"over", "00:00", "Mission time 20:00 of 20:00, running", Tone::Act}));
    EXPECT_EQ(at(seconds(1'230), minutes(20)).value, "00:30");
}

TEST(ClockWords, AClockThatStandsSaysSo) {
    EXPECT_EQ(at(minutes(3), minutes(20), false).caption, "paused");
}

TEST(RecordWords, AreCalmWhileAllIsWritten) {
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    RecordState state{.folder = "/missions/final", .megabytes = 12.34, .minutesLeft = 300.0};
    EXPECT_EQ(recordText(state).tone, Tone::Muted);
    EXPECT_EQ(recordText(state).value, "rec");
    EXPECT_THAT(recordText(state).details.toStdString(), HasSubstr("12.3 MB"));
    state.minutesLeft = std::numeric_limits<double>::infinity();
    EXPECT_EQ(recordText(state).tone, Tone::Muted);
    state.minutesLeft = 4.7;
    EXPECT_EQ(recordText(state).value, "rec · disk 4 min");
    EXPECT_EQ(recordText(state).tone, Tone::Attention);
    state.lost = 3;
    EXPECT_EQ(recordText(state).tone, Tone::Act);
    state.problem = "the disk is full";
    EXPECT_EQ(recordText(state).value, "not recording");
    EXPECT_THAT(recordText(state).details.toStdString(), HasSubstr("the disk is full"));
}

}  // namespace
}  // namespace leitstand
