#include "core/station/alarms/alarm_tone.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "core/station/alarms/alarm_voice.h"
#include "tests/core/robot/control_scene.h"

namespace leitstand::test {
namespace {

TEST(AlarmTone, BothBeginAndEndInSilenceAndDiffer) {
    constexpr int Rate = 44'100;
    for (const AlarmTone tone : {AlarmTone::Attention, AlarmTone::Act}) {
        const auto samples = toneSamples(tone, Rate);
        ASSERT_GT(samples.size(), Rate / 4u);
        EXPECT_LT(samples.size(), Rate * 1u);
        EXPECT_NEAR(samples.front(), 0.0F, 1e-3);
        EXPECT_NEAR(samples.back(), 0.0F, 1e-3);
        float most = 0.0F, step = 0.0F;
        for (std::size_t i = 1; i < samples.size(); ++i) {
            most = std::max(most, std::abs(samples[i]));
            step = std::max(step, std::abs(samples[i] - samples[i - 1]));
        }
        EXPECT_GT(most, 0.2F);
        EXPECT_LT(most, 1.0F);
        EXPECT_LT(step, 0.4F) << "nothing clicks";
    }
    EXPECT_NE(toneSamples(AlarmTone::Attention, Rate), toneSamples(AlarmTone::Act, Rate));
    EXPECT_TRUE(toneSamples(AlarmTone::Act, 0).empty());
}

TEST(AlarmVoice, AttentionIsHeardOnceActUntilItIsAcknowledged) {
    AlarmVoice voice;
    const Time never{};
    EXPECT_FALSE(voice.due(false, 0, never, wallAt(0)));
    EXPECT_EQ(voice.due(false, 1, never, wallAt(100)), AlarmTone::Attention);
    for (int i = 2; i < 50; ++i) EXPECT_FALSE(voice.due(false, 1, never, wallAt(100 * i)));
    EXPECT_EQ(voice.due(true, 1, never, wallAt(5'000)), AlarmTone::Act);
    int received = 0;
    for (int i = 1; i <= 60; ++i) received += voice.due(true, 1, never, wallAt(5'000 + 100 * i)) ? 1 : 0;
    EXPECT_EQ(received, 4) << "again and again";
    EXPECT_FALSE(voice.due(false, 1, never, wallAt(20'000))) << "acknowledged";
}

TEST(AlarmVoice, MutedNothingIsHeardNorMadeUpFor) {
    AlarmVoice voice;
    EXPECT_FALSE(voice.due(true, 3, wallAt(60'000), wallAt(0)));
    EXPECT_FALSE(voice.due(false, 4, wallAt(60'000), wallAt(59'000)));
    EXPECT_FALSE(voice.due(false, 4, wallAt(60'000), wallAt(60'000)));
    EXPECT_EQ(voice.due(true, 4, wallAt(60'000), wallAt(61'000)), AlarmTone::Act) << "what still stands is";
    EXPECT_EQ(voice.due(false, 5, wallAt(60'000), wallAt(62'000)), AlarmTone::Attention);
}

}  // namespace
}  // namespace leitstand::test
