#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <thread>

#include "tests/support/net/network_namespace.h"

namespace leitstand::test {

/// What the air between robot and station is like.
struct RadioConditions {
    double bitsPerSecond = 10e6;                  ///< shared by both directions, as on a WLAN
    std::chrono::milliseconds delay{20};          ///< of every packet, each way
    std::chrono::milliseconds jitter{0};          ///< more, from none to that; packets overtake each other
    double loss = 0.05;                           ///< share of packets that never arrive
    int mtu = 1500;                               ///< of what is larger, several packets are made [B]
    std::chrono::milliseconds longestQueue{200};  ///< what would wait longer for the air is dropped
    std::uint32_t seed = 1;
};

/// Two networks, the station's (10.99.0.1) and the robots' (10.99.0.2), with nothing but a radio link between
/// them: a shaper in user space. Use InNamespace to be on one of its sides.
class RadioLink {
public:
    explicit RadioLink(const RadioConditions& conditions = {});  ///< throws as NetworkNamespace does
    ~RadioLink();
    RadioLink(const RadioLink&) = delete;
    RadioLink& operator=(const RadioLink&) = delete;

    [[nodiscard]] const NetworkNamespace& station() const { return m_station; }
    [[nodiscard]] const NetworkNamespace& robots() const { return m_robots; }
    void setOutage(bool outage) { m_outage = outage; }                     ///< true: nothing arrives at all
    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }          ///< delivered, both ways
    [[nodiscard]] std::uint64_t congested() const { return m_congested; }  ///< packets dropped by full queues

private:
    void run(std::stop_token stop);

    RadioConditions m_conditions;
    NetworkNamespace m_station, m_robots;
    std::array<int, 2> m_ends{-1, -1};
    std::atomic<bool> m_outage = false;
    std::atomic<std::uint64_t> m_bytes = 0, m_congested = 0;
    std::jthread m_thread;
};

}  // namespace leitstand::test
