#include <gtest/gtest.h>
#include <QLocale>

#include "widgets/models/live/hold_to_act.h"
#include "widgets/models/live/texts/freshness.h"
#include "widgets/models/live/texts/picture_age.h"

namespace leitstand {
namespace {

using namespace std::chrono_literals;

const SteadyTime Begin = SteadyTime(100s);

class FreshnessTest : public testing::Test {
protected:
    void SetUp() override { QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates)); }
};

TEST_F(FreshnessTest, GoesFromLiveOverStaleToLost) {
    EXPECT_EQ(freshnessOf({}), Freshness::Never);
    EXPECT_EQ(freshnessOf({.arrival = 0.99}), Freshness::Live);
    EXPECT_EQ(freshnessOf({.arrival = 1.0}), Freshness::Stale);
    EXPECT_EQ(freshnessOf({.arrival = 2.99}), Freshness::Stale);
    EXPECT_EQ(freshnessOf({.arrival = 3.0}), Freshness::Lost);
    EXPECT_EQ(freshnessOf({.arrival = 0.1, .content = 2.0}), Freshness::Stale);
    EXPECT_EQ(freshnessOf({.arrival = 0.1, .content = 3.5}), Freshness::Lost);
    EXPECT_EQ(toneOf(Freshness::Live), Tone::Muted);
    EXPECT_EQ(toneOf(Freshness::Lost), Tone::Attention);
}

TEST_F(FreshnessTest, IsSaidInWords) {
    EXPECT_EQ(ageText({.arrival = 0.064}).toStdString(), "64 ms");
    EXPECT_EQ(ageText({.arrival = 1.44}).toStdString(), "1.4 s");
    EXPECT_EQ(ageText({.arrival = 0.1, .content = 2.42}).toStdString(), "same for 2.4 s");
    EXPECT_EQ(ageText({.arrival = 0.1, .content = 0.2}).toStdString(), "200 ms");
    EXPECT_EQ(ageText({}).toStdString(), "no data yet");
    EXPECT_EQ(lossText({.arrival = 2.0}).toStdString(), "");
    EXPECT_EQ(lossText({.arrival = 4.9}).toStdString(), "no data for 4 s");
    EXPECT_EQ(lossText({.arrival = 200.0}).toStdString(), "no data for 3 min");
    EXPECT_EQ(lossText({.arrival = 0.1, .content = 4.0}).toStdString(), "the same picture for 4 s");
    EXPECT_EQ(lossText({}).toStdString(), "no data yet");
}

TEST_F(FreshnessTest, ADriverThatRestampsOnePictureIsFoundOut) {
    PictureAge age;
    EXPECT_EQ(freshnessOf(age.at(Begin)), Freshness::Never);
    for (int i = 0; i <= 20; ++i) age.arrived(static_cast<std::uint64_t>(i), Begin + i * 100ms);
    EXPECT_EQ(freshnessOf(age.at(Begin + 2050ms)), Freshness::Live);
    for (int i = 21; i <= 50; ++i) age.arrived(20, Begin + i * 100ms);
    EXPECT_NEAR(age.at(Begin + 5s).arrival, 0.0, 1e-9);
    EXPECT_NEAR(age.at(Begin + 5s).content, 3.0, 1e-9);
    EXPECT_EQ(freshnessOf(age.at(Begin + 5s)), Freshness::Lost);
    age.arrived(21, Begin + 5100ms);
    EXPECT_EQ(freshnessOf(age.at(Begin + 5100ms)), Freshness::Live);
}

TEST_F(FreshnessTest, HoldingTakesAFullSecondWithoutABreak) {
    HoldToAct hold;
    EXPECT_FALSE(hold.due(Begin));
    hold.begin(Begin);
    EXPECT_FALSE(hold.due(Begin + 999ms));
    EXPECT_NEAR(hold.progress(Begin + 250ms), 0.25, 1e-9);
    hold.end();
    EXPECT_FALSE(hold.due(Begin + 2s));
    hold.begin(Begin + 2s);
    hold.begin(Begin + 2500ms);  // a repeated press is the same one
    EXPECT_TRUE(hold.due(Begin + 3s));
    EXPECT_FALSE(hold.due(Begin + 4s)) << "once";
    EXPECT_EQ(hold.progress(Begin + 9s), 1.0);
    hold.end();
    hold.begin(Begin + 10s);
    EXPECT_TRUE(hold.due(Begin + 11s));
}

}  // namespace
}  // namespace leitstand
