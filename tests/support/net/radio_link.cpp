#include "tests/support/net/radio_link.h"

#include <algorithm>
#include <cstddef>
#include <deque>
#include <random>
#include <vector>

#include <poll.h>
#include <unistd.h>

namespace leitstand::test {
namespace {

using Clock = std::chrono::steady_clock;

struct Packet {
    Clock::time_point due;
    int to;
    std::vector<std::byte> bytes;
};

}  // namespace

RadioLink::RadioLink(const RadioConditions& conditions)
    : m_conditions(conditions),
      m_ends{m_station.addInterface("10.99.0.1", conditions.mtu),
             m_robots.addInterface("10.99.0.2", conditions.mtu)} {
    m_thread = std::jthread([this](std::stop_token stop) { run(std::move(stop)); });
}

RadioLink::~RadioLink() {
    m_thread.request_stop();
    m_thread.join();
    for (const int end : m_ends) close(end);
}

void RadioLink::run(std::stop_token stop) {
    std::mt19937 random(m_conditions.seed);
    std::bernoulli_distribution lost(m_conditions.loss);
    std::uniform_real_distribution<double> late(0.0,
                                                std::chrono::duration<double>(m_conditions.jitter).count());
    std::deque<Packet> flying;  // in the order in which they arrive
    Clock::time_point airFree = Clock::now();
    const auto accept = [&](int to, std::vector<std::byte> bytes) {
        const auto now = Clock::now();
        airFree = std::max(airFree, now);
        if (m_outage) return;
        if (airFree - now > m_conditions.longestQueue) {
            ++m_congested;
            return;
        }
        const double seconds = 8.0 * static_cast<double>(bytes.size()) / m_conditions.bitsPerSecond;
        airFree += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
        if (lost(random)) return;
        const auto jitter =
            std::chrono::duration<double>(m_conditions.jitter.count() > 0 ? late(random) : 0.0);
        const auto due = airFree + m_conditions.delay + std::chrono::duration_cast<Clock::duration>(jitter);
        const auto place = std::upper_bound(flying.begin(), flying.end(), due,
                                            [](auto moment, const Packet& one) { return moment < one.due; });
        flying.insert(place, {due, to, std::move(bytes)});
    };
    std::vector<std::byte> buffer(65536);
    while (!stop.stop_requested()) {
        std::array<pollfd, 2> polled{pollfd{m_ends[0], POLLIN, 0}, pollfd{m_ends[1], POLLIN, 0}};
        auto patience = Clock::duration(std::chrono::milliseconds(50));
        if (!flying.empty())
            patience = std::clamp(flying.front().due - Clock::now(), Clock::duration(0), patience);
        const auto ns = std::chrono::duration_cast<std::chrono::nanoseconds>(patience).count();
        const timespec timeout{0, static_cast<long>(ns)};
        ppoll(polled.data(), polled.size(), &timeout, nullptr);
        for (std::size_t i = 0; i < 2; ++i) {
            for (ssize_t n = 0; (n = read(m_ends[i], buffer.data(), buffer.size())) > 0;) {
                accept(m_ends[1 - i], {buffer.begin(), buffer.begin() + n});
            }
        }
        for (; !flying.empty() && flying.front().due <= Clock::now(); flying.pop_front()) {
            const Packet& packet = flying.front();
            if (m_outage) continue;
            if (write(packet.to, packet.bytes.data(), packet.bytes.size()) > 0)
                m_bytes += packet.bytes.size();
        }
    }
}

}  // namespace leitstand::test
