#include <cmath>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/event/command_samples.h"
#include "core/event/scan_links.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_defaults.h"
#include "tests/transport/link/link_robot.h"
#include "tests/transport/link/link_station.h"
#include "transport/convert/decode.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

double toSeconds(std::chrono::nanoseconds duration) {
    return std::chrono::duration<double>(duration).count();
}

class Link : public testing::Test {
protected:
    [[nodiscard]] std::unique_ptr<LinkRobot> robot() const {
        return std::make_unique<LinkRobot>(m_domain.number(), m_robot);
    }
    const TestDomain m_domain;
    const RobotDescription m_robot = pingableRobot();
    const std::unique_ptr<Node> m_node = nodeIn(m_domain);
};

TEST_F(Link, RoundTripAndAClock5SecondsOffAreMeasured) {
    LinkStation station(*m_node, m_robot);
    EXPECT_EQ(station.status().state, LinkState::NeverSeen);
    const auto kurt = robot();
    kurt->setAhead(5s);
    ASSERT_TRUE(station.hearsPongs(5));
    const LinkStatus link = station.status();
    ASSERT_TRUE(link.clock && link.roundTrip);
    std::printf("round trip %.2f ms (median), clock %.3f ms off 5 s, +- %.2f ms\n",
                1e3 * link.roundTrip->median, 1e3 * (toSeconds(link.clock->ahead) - 5.0),
                1e3 * toSeconds(link.clock->uncertainty));
    EXPECT_GT(link.roundTrip->median, 0.0);
    EXPECT_LT(link.roundTrip->median, 0.1);
    EXPECT_NEAR(toSeconds(link.clock->ahead), 5.0, 0.020);
    EXPECT_NEAR(toSeconds(link.clock->ahead), 5.0, toSeconds(link.clock->uncertainty));
    EXPECT_EQ(link.clock->source, ClockSource::Pings);
    EXPECT_NEAR(link.stream("/kurt3d/odom")->rate, 20.0, 5.0);
    EXPECT_GT(link.stream("/kurt3d/odom")->megabitsPerSecond, 0.05);
    EXPECT_EQ(link.stream("/kurt3d/odom")->lost, 0U);
}

TEST_F(Link, ARobotThatFallsSilentIsLostAndComesBackByItself) {
    LinkStation station(*m_node, m_robot);
    const auto kurt = robot();
    ASSERT_TRUE(station.hearsPongs(2));
    kurt->setSpeaking(false);
    kurt->setAnswering(false);
    ASSERT_TRUE(station.becomes(LinkState::Lost, 10s));
    EXPECT_THAT(toString(station.status().reasons), HasSubstr("nothing heard for"));
    kurt->setSpeaking(true);
    kurt->setAnswering(true);
    ASSERT_TRUE(station.becomes(LinkState::Connected, 10s));
    EXPECT_EQ(station.status().reconnects, 1);
    EXPECT_EQ(station.status().stream("/kurt3d/odom")->lost, 0U);
    EXPECT_EQ(station.states().front(), LinkState::Connected);
    EXPECT_EQ(station.states().back(), LinkState::Connected);
    EXPECT_THAT(station.states(), testing::Contains(LinkState::Lost));
}

TEST_F(Link, ARobotThatEndedAndBeganAgainHasLostNothing) {
    LinkStation station(*m_node, m_robot);
    auto kurt = robot();
    ASSERT_TRUE(station.hearsPongs(2));
    kurt.reset();
    ASSERT_TRUE(station.becomes(LinkState::Lost, 10s));
    kurt = robot();
    ASSERT_TRUE(station.becomes(LinkState::Connected));
    EXPECT_EQ(station.status().stream("/kurt3d/odom")->lost, 0U);
    const std::size_t before = station.pongs().size();
    EXPECT_TRUE(waitUntil([&] { return station.pongs().size() > before; }));  // pinged again
}

TEST_F(Link, ARobotThatWasKilledIsFoundAgainBesideItsRemains) {
    LinkStation station(*m_node, m_robot);
    const auto dead = robot();
    ASSERT_TRUE(station.hearsPongs(2));
    dead->setSpeaking(false);  // as after kill -9: nobody says that it went
    dead->setAnswering(false);
    ASSERT_TRUE(station.becomes(LinkState::Lost, 10s));
    const auto alive = robot();
    ASSERT_TRUE(station.becomes(LinkState::Connected));
    EXPECT_EQ(station.status().stream("/kurt3d/odom")->lost, 0U);
    EXPECT_TRUE(
        waitUntil([&] { return station.status().roundTrip && station.status().roundTrip->age < 1.0; }));
}

TEST_F(Link, ARobotThatHearsNoPingsIsDegraded) {
    LinkStation station(*m_node, m_robot);
    const auto kurt = robot();
    ASSERT_TRUE(station.hearsPongs(2));
    kurt->setAnswering(false);
    ASSERT_TRUE(station.becomes(LinkState::Degraded, 10s));
    EXPECT_THAT(toString(station.status().reasons), HasSubstr("no answer to pings for"));
    kurt->setAnswering(true);
    EXPECT_TRUE(station.becomes(LinkState::Connected, 10s));
}

TEST_F(Link, AStepOfTheRobotsClockIsFollowedAndLogged) {
    LinkStation station(*m_node, m_robot);
    const auto kurt = robot();
    ASSERT_TRUE(station.hearsPongs(3) && waitUntil([&] { return !station.offsets().empty(); }));
    EXPECT_EQ(station.offsets()[0].robot, "kurt3d");
    EXPECT_NEAR(toSeconds(station.offsets()[0].ahead), 0.0, 0.050);
    kurt->setAhead(-5s);
    ASSERT_TRUE(waitUntil([&] { return toSeconds(station.offsets().back().ahead) < -4.9; }, 10s));
    EXPECT_NEAR(toSeconds(station.offsets().back().ahead), -5.0, 0.020);
    EXPECT_EQ(station.status().clock->steps, 1);
    EXPECT_LE(station.offsets().size(), 8U);  // on change only
}

TEST_F(Link, StationsGetTheirOwnAnswersOnly) {
    const auto other = nodeIn(m_domain);
    LinkStation one(*m_node, m_robot, "station one"), two(*other, m_robot, "station two");
    const auto kurt = robot();
    ASSERT_TRUE(one.becomes(LinkState::Connected) && two.becomes(LinkState::Connected));
    ASSERT_TRUE(waitUntil([&] { return one.pongs().size() >= 8 && two.pongs().size() >= 8; }));
    for (LinkStation* station : {&one, &two}) {
        ASSERT_TRUE(station->status().roundTrip);
        EXPECT_LT(station->status().roundTrip->median, 0.1);
        EXPECT_LT(std::abs(toSeconds(station->status().clock->ahead)), 0.020);
        EXPECT_EQ(station->status().clock->steps, 0);
        EXPECT_LT(station->status().roundTrip->unanswered, 0.2);
    }
}

TEST_F(Link, PingsRiseOverRestartsOfTheStation) {
    const auto kurt = robot();
    std::uint64_t before = 0;
    for (int i = 0; i < 3; ++i) {
        LinkStation station(*m_node, m_robot);
        ASSERT_TRUE(waitUntil([&] { return kurt->lastPing() > before; }));
        ASSERT_TRUE(waitUntil([&] { return station.status().roundTrip.has_value(); }));
        before = kurt->lastPing();
    }
}

TEST_F(Link, WhatIsSaidAndHeardIsGivenToTheLog) {
    LinkStation station(*m_node, m_robot);
    const auto kurt = robot();
    ASSERT_TRUE(waitUntil([&] { return station.pongs().size() >= 2; }));
    const auto ping = decode(station.pings()[0], *m_robot.stream(StreamRole::Ping));
    const auto pong = decode(station.pongs()[0], *m_robot.stream(StreamRole::Pong));
    ASSERT_TRUE(ping && pong);
    EXPECT_EQ(ping->get<PingSample>().station, "station one");
    EXPECT_EQ(pong->get<PongSample>().station, "station one");
    EXPECT_EQ(station.pings()[0].topic, "/kurt3d/ping");
    EXPECT_EQ(station.pongs()[0].topic, "/kurt3d/pong");
}

TEST_F(Link, NonsenseForAnswersIsCounted) {
    LinkStation station(*m_node, m_robot);
    const auto kurt = robot();
    kurt->setAnswering(false);
    kurt->setGarbage(true);
    ASSERT_TRUE(waitUntil([&] { return station.client().brokenPongs() >= 2; }));
    EXPECT_FALSE(station.status().roundTrip);
    kurt->setAnswering(true);
    EXPECT_TRUE(waitUntil([&] { return station.status().roundTrip.has_value(); }));
}

TEST_F(Link, ARobotWithoutPingAndPongIsWatchedByItsSamples) {
    RobotDescription plain = m_robot;
    std::erase_if(plain.streams, [](const StreamDescription& stream) {
        return stream.role == StreamRole::Ping || stream.role == StreamRole::Pong;
    });
    LinkStation station(*m_node, plain);
    const auto kurt = robot();
    ASSERT_TRUE(station.becomes(LinkState::Connected));
    ASSERT_TRUE(waitUntil([&] { return station.status().clock.has_value(); }));
    EXPECT_EQ(station.status().clock->source, ClockSource::Stamps);
    EXPECT_NEAR(toSeconds(station.status().clock->ahead), 0.0,
                toSeconds(station.status().clock->uncertainty) + 0.050);
    EXPECT_EQ(kurt->pings(), 0U);
    EXPECT_FALSE(station.status().roundTrip);
}

TEST_F(Link, APingOfAnotherTypeIsRefusedInWords) {
    RobotDescription wrong = m_robot;
    for (StreamDescription& stream : wrong.streams) {
        if (stream.role == StreamRole::Ping) stream.type = "nav_msgs/msg/Odometry";
    }
    const auto client = LinkClient::create(*m_node, wrong);
    ASSERT_FALSE(client);
    EXPECT_THAT(client.error().text, HasSubstr("/kurt3d/ping"));
}

TEST_F(Link, EndsAtOnceWhileSamplesCome) {
    const auto kurt = robot();
    for (int i = 0; i < 20; ++i) {
        auto station = std::make_unique<LinkStation>(*m_node, m_robot);
        ASSERT_TRUE(waitUntil([&] { return station->status().stream("/kurt3d/odom")->samples > 2; }));
        const auto begin = std::chrono::steady_clock::now();
        station.reset();
        EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
    }
}

TEST_F(Link, MayOutliveItsNode) {
    auto node = nodeIn(m_domain);
    LinkStation station(*node, m_robot);
    const auto kurt = robot();
    ASSERT_TRUE(station.hearsPongs(2));
    node.reset();
    EXPECT_TRUE(station.becomes(LinkState::Lost, 10s));
}

}  // namespace
}  // namespace leitstand::test
