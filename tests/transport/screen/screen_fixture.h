#pragma once

#include <chrono>
#include <cstdint>

#include <gtest/gtest.h>

#include "tests/transport/screen/packets.h"

namespace leitstand::test {

constexpr std::int64_t Huge = std::int64_t(1) << 62;

/// A screen with a clock of its own, and the robot 1 on 10.0.0.7 that it has let in long ago.
class ScreenTest : public testing::Test {
protected:
    explicit ScreenTest(const screen::ScreenSettings& settings = {}) : m_screen(settings) {
        EXPECT_TRUE(takes(Packet().announce()));
        EXPECT_TRUE(takes(Packet().announceEndpoint(OdometryWriter)));
        EXPECT_TRUE(takes(Packet().announceEndpoint(OdometryReader, false)));
        m_now += std::chrono::seconds(60);
        EXPECT_TRUE(takes(Packet().heartbeat(screen::entity::PublicationsWriter, 1, 1)));
    }
    bool takes(const Packet& packet, const screen::Place& from = placeOf(7)) {
        return m_screen.passes(packet.bytes(), from, m_now);
    }
    [[nodiscard]] std::uint64_t dropped(ScreenDrop::Kind why) const {
        std::uint64_t packets = 0;
        for (const ScreenDrop& drop : m_screen.drops()) packets += drop.kind == why ? drop.packets : 0;
        return packets;
    }

    screen::Screen m_screen;
    screen::Moment m_now = screen::Moment(std::chrono::hours(1));
};

}  // namespace leitstand::test
