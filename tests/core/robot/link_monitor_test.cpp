#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/station_samples.h"
#include "core/event/stream_role.h"
#include "tests/core/robot/link_scene.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

double toSeconds(std::chrono::nanoseconds duration) {
    return std::chrono::duration<double>(duration).count();
}

TEST(LinkMonitor, ARobotThatNeverSpokeWasNeverSeen) {
    LinkScene scene;
    scene.on = false;
    scene.run(30.0);
    EXPECT_THAT(scene.states(), ElementsAre("never seen"));
    const LinkStatus link = scene.status();
    EXPECT_THAT(link.reasons, IsEmpty());
    EXPECT_TRUE(std::isinf(link.silence));
    EXPECT_FALSE(link.clock);
    EXPECT_FALSE(link.roundTrip);
    EXPECT_EQ(link.streams.size(), 7U);  // commands left out
}

TEST(LinkMonitor, AGoodLinkIsConnectedAndTellsItsFigures) {
    LinkScene scene;
    scene.publish("mode");
    scene.run(120.0);
    EXPECT_THAT(scene.states(), ElementsAre("connected"));
    const LinkStatus link = scene.status();
    EXPECT_EQ(link.robot, "kurt3d");
    EXPECT_NEAR(link.stateAge, 120.0, 1.0);
    EXPECT_LT(link.silence, 0.1);
    for (const auto& [key, stream] : scene.streams) {
        const StreamStatus* status = link.stream(stream.topic);
        ASSERT_NE(status, nullptr) << key;
        EXPECT_LE(status->samples, stream.reported) << key;
        EXPECT_GE(status->samples + 1, stream.reported) << key;  // one may be on its way
        EXPECT_FALSE(status->stale) << key;
        if (stream.rate <= 0.0) continue;
        EXPECT_TRUE(status->steady) << key;
        EXPECT_NEAR(status->rate, stream.rate, 0.1 * stream.rate) << key;
        EXPECT_NEAR(status->expectedRate, stream.rate, 0.05 * stream.rate) << key;
        EXPECT_LT(status->age, 1.1 / stream.rate) << key;
        EXPECT_NEAR(status->delay, stream.delay, 0.01) << key;
    }
    EXPECT_NEAR(link.megabitsPerSecond, 36 * 0.008, 0.05);
    EXPECT_NEAR(link.roundTrip->median, 0.04, 0.001);
    EXPECT_NEAR(link.roundTrip->last, 0.04, 0.001);
    EXPECT_EQ(link.roundTrip->unanswered, 0.0);
    EXPECT_NEAR(toSeconds(link.clock->ahead), 5.0, 0.005);
    EXPECT_FALSE(link.stream("/kurt3d/mode")->steady);
    EXPECT_GT(link.stream("/kurt3d/mode")->age, 100.0);  // on change: never stale
    EXPECT_EQ(link.stream("/kurt3d/nothing"), nullptr);
}

TEST(LinkMonitor, ALostRobotIsToldAfter2SecondsAndComesBackByItself) {
    LinkScene scene;
    scene.run(20.0);
    for (int outage = 1; outage <= 3; ++outage) {
        scene.forgetStates();
        scene.radio = false;
        const double begin = scene.now();
        scene.run(2.5);
        EXPECT_THAT(scene.states(), ElementsAre("connected", testing::AnyOf("degraded", "lost"), "lost"));
        EXPECT_NEAR(scene.changedAt() - begin, 2.0, 0.2);
        scene.run(5.5);
        EXPECT_THAT(toString(scene.status().reasons), HasSubstr("nothing heard for 8."));
        EXPECT_NEAR(scene.status().silence, 8.0, 0.2);
        scene.radio = true;
        const double back = scene.now();
        scene.run(0.5);
        EXPECT_NE(scene.status().state, LinkState::Lost);
        EXPECT_EQ(scene.status().reconnects, outage);
        scene.run(20.0);
        EXPECT_EQ(scene.status().state, LinkState::Connected);
        EXPECT_LT(scene.changedAt() - back, 15.0);
        EXPECT_THAT(scene.status().reasons, IsEmpty());
    }
}

TEST(LinkMonitor, AShortGapIsNoLoss) {
    LinkScene scene;
    scene.run(20.0);
    scene.radio = false;
    scene.run(0.5);
    scene.radio = true;
    scene.run(20.0);
    EXPECT_THAT(scene.states(), ElementsAre("connected"));
}

TEST(LinkMonitor, ARestartedRobotHasLostNothing) {
    LinkScene scene;
    scene.run(30.0);
    scene.on = false;
    scene.run(5.0);
    scene.restartRobot();
    scene.on = true;
    scene.run(1.0);
    EXPECT_NE(scene.status().state, LinkState::Lost);
    for (const LinkReason& reason : scene.status().reasons) EXPECT_EQ(reason.kind, LinkReason::Kind::Stale);
    scene.run(4.0);
    for (const StreamStatus& stream : scene.status().streams) EXPECT_EQ(stream.lost, 0U) << stream.topic;
    EXPECT_EQ(scene.status().state, LinkState::Connected);
    EXPECT_EQ(scene.status().reconnects, 1);
}

TEST(LinkMonitor, AStreamThatStopsDegradesItUntilItComesAgain) {
    LinkScene scene;
    scene.run(20.0);
    scene.streams["odom"].silent = true;
    scene.run(1.5);
    LinkStatus link = scene.status();
    EXPECT_EQ(link.state, LinkState::Degraded);
    ASSERT_EQ(link.reasons.size(), 1U);
    EXPECT_EQ(link.reasons[0].kind, LinkReason::Kind::Stale);
    EXPECT_EQ(link.reasons[0].role, StreamRole::Odometry);
    EXPECT_THAT(toString(link.reasons), testing::MatchesRegex("odometry 1\\.. s old"));
    EXPECT_TRUE(link.stream("/kurt3d/odom")->stale);
    scene.streams["odom"].silent = false;
    scene.run(1.0);
    EXPECT_EQ(scene.status().state, LinkState::Degraded);  // not at once
    EXPECT_FALSE(scene.status().stream("/kurt3d/odom")->stale);
    scene.run(1.5);
    EXPECT_EQ(scene.status().state, LinkState::Connected);
}

TEST(LinkMonitor, SlowStreamsAreGivenThreeOfTheirIntervals) {
    LinkScene scene;
    scene.run(20.0);
    scene.streams["co2"].silent = true;
    scene.run(2.0);
    EXPECT_EQ(scene.status().state, LinkState::Connected);
    scene.run(2.0);
    EXPECT_THAT(toString(scene.status().reasons), testing::MatchesRegex("gas [34]\\.. s old"));
}

TEST(LinkMonitor, AStreamThatIsSwitchedOffIsNoMatterOfTheLink) {
    LinkScene scene;
    scene.run(20.0);
    scene.monitor.setPaused("/kurt3d/left/image/compressed", true, scene.steadyNow());
    scene.streams["left"].silent = true;
    scene.run(20.0);
    EXPECT_THAT(scene.states(), ElementsAre("connected"));
    EXPECT_TRUE(scene.status().stream("/kurt3d/left/image/compressed")->paused);
    scene.monitor.setPaused("/kurt3d/left/image/compressed", false, scene.steadyNow());
    scene.run(0.5);
    EXPECT_EQ(scene.status().state, LinkState::Connected);  // it may need a moment
    scene.run(1.0);
    EXPECT_THAT(toString(scene.status().reasons), HasSubstr("left pictures"));
    scene.run(70.0);  // by itself, and for good: told of the stream, no longer of the link
    EXPECT_EQ(scene.status().state, LinkState::Connected);
    EXPECT_TRUE(scene.status().stream("/kurt3d/left/image/compressed")->stale);
    EXPECT_GT(scene.status().stream("/kurt3d/left/image/compressed")->lossRatio, 0.99)
        << "none of what has to come";
}

TEST(LinkMonitor, LossOverATenthIsTold) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        LinkScene scene(true, seed);
        for (auto& [key, stream] : scene.streams) stream.loss = 0.03;
        scene.run(120.0);
        EXPECT_THAT(scene.states(), ElementsAre("connected")) << seed;
        scene.streams["points"].loss = 0.25;
        scene.run(20.0);
        const LinkStatus link = scene.status();
        EXPECT_EQ(link.state, LinkState::Degraded);
        EXPECT_THAT(toString(link.reasons), testing::MatchesRegex("[0-9]+ % of points lost"));
        EXPECT_NEAR(link.stream("/kurt3d/points")->lossRatio, 0.25, 0.15);
        scene.forgetStates();
        scene.streams["points"].loss = 0.0;
        scene.run(60.0);
        EXPECT_THAT(scene.states(), ElementsAre("degraded", "connected")) << seed;
    }
}

TEST(LinkMonitor, ALossAroundTheLimitDoesNotFlap) {
    LinkScene scene;
    scene.streams["odom"].loss = 0.10;
    scene.run(600.0);
    EXPECT_LT(scene.states().size(), 15U);  // of 6000 judgements
}

TEST(LinkMonitor, LateSamplesAreTold) {
    LinkScene scene;
    scene.run(20.0);
    scene.streams["points"].delay = 3.0;
    scene.run(10.0);
    EXPECT_EQ(scene.status().state, LinkState::Degraded);
    EXPECT_THAT(toString(scene.status().reasons), HasSubstr("points 3.0 s late"));
    EXPECT_NEAR(scene.status().stream("/kurt3d/points")->delay, 3.0, 0.02);
    scene.streams["points"].delay = 0.02;
    scene.run(10.0);
    EXPECT_EQ(scene.status().state, LinkState::Connected);
}

TEST(LinkMonitor, OfAStreamWithAClockOfItsOwnNoDelayIsTold) {
    for (const double error : {-3.0, 3.0}) {
        LinkScene scene;
        scene.streams["left"].clockError = error;
        scene.run(30.0);
        EXPECT_THAT(scene.states(), ElementsAre("connected"));
        EXPECT_TRUE(std::isnan(scene.status().stream("/kurt3d/left/image/compressed")->delay));
        EXPECT_NEAR(scene.status().stream("/kurt3d/odom")->delay, 0.02, 0.01);
    }
}

TEST(LinkMonitor, ALongRoundTripIsTold) {
    LinkScene scene;
    scene.run(20.0);
    scene.roundTrip = 0.38;
    scene.run(15.0);
    EXPECT_EQ(scene.status().state, LinkState::Degraded);
    EXPECT_EQ(toString(scene.status().reasons), "round trip 380 ms");
    scene.roundTrip = 0.25;  // less than the limit, but not yet over
    scene.run(15.0);
    EXPECT_EQ(scene.status().state, LinkState::Degraded);
    scene.roundTrip = 0.04;
    scene.run(15.0);
    EXPECT_EQ(scene.status().state, LinkState::Connected);
}

TEST(LinkMonitor, ARobotThatSpeaksButHearsNothingIsDegraded) {
    LinkScene scene;
    scene.run(20.0);
    scene.roundTrip = 1e9;  // its answers never come
    scene.run(5.0);
    EXPECT_EQ(scene.status().state, LinkState::Degraded);
    EXPECT_THAT(toString(scene.status().reasons), HasSubstr("no answer to pings for"));
    EXPECT_GT(scene.status().roundTrip->unanswered, 0.1);
    scene.roundTrip = 0.04;
    scene.run(5.0);
    EXPECT_EQ(scene.status().state, LinkState::Connected);
}

TEST(LinkMonitor, ARobotWithoutPongIsWatchedByItsSamples) {
    LinkScene scene(/*pong=*/false);
    scene.run(30.0);
    EXPECT_THAT(scene.states(), ElementsAre("connected"));
    const LinkStatus link = scene.status();
    EXPECT_FALSE(link.roundTrip);
    ASSERT_TRUE(link.clock);
    EXPECT_EQ(link.clock->source, ClockSource::Stamps);
    EXPECT_NEAR(toSeconds(link.clock->ahead), 5.0, toSeconds(link.clock->uncertainty));
    scene.on = false;
    scene.run(3.0);
    EXPECT_EQ(scene.status().state, LinkState::Lost);
}

TEST(LinkMonitor, ARobotOfSlowStreamsIsGivenTime) {
    LinkScene scene(/*pong=*/false);
    for (const char* key : {"odom", "points", "left"}) scene.streams[key].rate = 0.0;
    scene.run(30.0);
    scene.forgetStates();
    scene.on = false;
    scene.run(3.5);
    EXPECT_NE(scene.status().state, LinkState::Lost);
    scene.run(2.0);
    EXPECT_EQ(scene.status().state, LinkState::Lost);
}

TEST(LinkMonitor, WhatOthersSayOnSharedTopicsIsNoSignOfLife) {
    LinkScene scene;
    scene.run(20.0);
    for (const char* key : {"odom", "points", "left", "co2"}) scene.streams[key].silent = true;
    scene.roundTrip = 1e9;
    scene.streams["diagnostics"].rate = 5.0;
    scene.run(10.0);
    EXPECT_EQ(scene.status().state, LinkState::Lost);
    EXPECT_NEAR(scene.status().stream("/diagnostics")->rate, 5.0, 0.3);
}

TEST(LinkMonitor, AClockThatStepsIsToldAndIsNoFaultOfTheLink) {
    LinkScene scene;
    scene.run(30.0);
    scene.ahead = 0.0;
    scene.run(2.1);
    const LinkStatus link = scene.status();
    EXPECT_NEAR(toSeconds(link.clock->ahead), 0.0, 0.005);
    EXPECT_EQ(link.clock->steps, 1);
    EXPECT_NEAR(toSeconds(link.clock->lastStep), -5.0, 0.02);
    EXPECT_LT(link.clock->stepAge, 2.0);
    scene.run(30.0);
    EXPECT_EQ(scene.status().clock->steps, 1);
    EXPECT_THAT(scene.states(), ElementsAre("connected"));
}

TEST(LinkMonitor, ARobotThatComesAndGoesDoesNotFlapForSingleSamples) {
    LinkScene scene;
    scene.run(20.0);
    scene.on = false;
    scene.run(4.0);
    scene.forgetStates();
    for (int i = 0; i < 10; ++i) {
        scene.publish("co2");
        scene.run(4.0);
    }
    EXPECT_LE(scene.states().size(), 7U);  // every third sample may look like a return
}

TEST(LinkMonitor, ForeignTopicsAndAnswersAreIgnored) {
    LinkScene scene;
    scene.on = false;
    const SteadyTime now = scene.steadyNow();
    scene.monitor.sample("/crawler/odom", {10, {1}, 1, {}, {}}, now);
    scene.monitor.sample("", {10, {1}, 1, {}, {}}, now);
    EXPECT_FALSE(scene.monitor.pong({7, "station", {}, {}, {}}, {}, now));
    scene.run(1.0);
    EXPECT_EQ(scene.status().state, LinkState::NeverSeen);
}

TEST(LinkMonitor, TheLogKeepsTheOffsetAsItIsKnown) {
    LinkScene scene;
    EXPECT_FALSE(clockOffsetOf(scene.status(), Time{}));
    scene.run(20.0);
    const Time stamp{1s};
    const auto sample = clockOffsetOf(scene.status(), stamp);
    ASSERT_TRUE(sample);
    EXPECT_EQ(sample->robot, "kurt3d");
    EXPECT_EQ(sample->stamp, stamp);
    EXPECT_NEAR(toSeconds(sample->ahead), 5.0, 0.005);
    EXPECT_NEAR(toSeconds(sample->uncertainty), 0.021 / std::sqrt(3.0), 0.001);
    EXPECT_NEAR(toSeconds(sample->roundTrip), 0.04, 0.001);
}

}  // namespace
}  // namespace leitstand::test
