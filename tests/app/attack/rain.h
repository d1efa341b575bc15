#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

#include "tests/transport/screen_wire/mutations.h"

namespace leitstand::test {

/// What a robot and who listens to it say to each other in a domain of their own.
[[nodiscard]] std::vector<RecordedPacket> trafficOfARobot(std::size_t packets);

/// Datagrams of every kind that fall on a domain, a thousand a second: recorded ones as they were, mutated
/// ones, statistics at the wrong place, and participants with topics that nobody knows.
class Rain {
public:
    Rain(int domain, const std::vector<RecordedPacket>& traffic, unsigned seed);

    [[nodiscard]] std::uint64_t fallen() const { return m_turn; }  ///< datagrams, and strangers announced

private:
    void drop();

    Attacker m_attacker;
    const std::vector<RecordedPacket>& m_traffic;
    Mutator m_mutator;
    std::atomic<std::size_t> m_turn = 0;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand::test
