#include <atomic>
#include <chrono>
#include <csignal>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/places.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int Pictures = static_cast<int>(Flow::Pictures);

/// Lets a process run for a moment only, now and then, as a busy computer does.
class Hindered {
public:
    Hindered(const ChildProcess& process, std::chrono::milliseconds runs, std::chrono::milliseconds waits)
        : m_process(process), m_thread([this, runs, waits](const std::stop_token& stop) {
              while (!stop.stop_requested()) {
                  m_process.signal(SIGSTOP);
                  std::this_thread::sleep_for(waits);
                  m_process.signal(SIGCONT);
                  std::this_thread::sleep_for(runs);
              }
          }) {}

private:
    const ChildProcess& m_process;
    std::jthread m_thread;
};

// 200 kB a second, less than half of what the pictures' limit lets pass: 26 samples of 13 kB in two seconds.
TEST(Flow, KeepsItsLimitThoughItsThreadGetsTheProcessorLate) {
    const TestDomain domain;
    const auto station = nodeIn(domain);
    std::atomic<int> received = 0;
    const auto listening =
        must(station->subscribe({"/k/left", TestType, bestEffort(), Lane::Large}, [&](auto) { ++received; }));
    const ChildProcess talker(program("dds_peer"),
                              {"talk", std::to_string(domain.number()), "/k/left", "reliable=0", "size=13000",
                               "period=60", "flow=" + std::to_string(Pictures)});
    ASSERT_TRUE(waitUntil([&] { return received > 5; }));
    const auto before = listening->counts();
    const Hindered hindered(talker, 3ms, 9ms);
    std::this_thread::sleep_for(5s);  // is what is measured
    const auto after = listening->counts();
    EXPECT_GT(after.samples - before.samples, 40U);
    EXPECT_EQ(after.lost, before.lost) << "of " << after.samples - before.samples;
}

TEST(Flow, TelemetryThatWaitsForItsThreadIsNotOverwritten) {
    const TestDomain domain;
    const auto robot = nodeIn(domain), station = nodeIn(domain);
    Inbox ear;
    const auto received = must(station->subscribe({"/k/tf", TestType, bestEffort(100)}, ear.callback()));
    const auto reported = must(robot->publisher({"/k/tf", TestType, bestEffort(10), Flow::Telemetry}));
    ASSERT_TRUE(waitUntil([&] {
        static_cast<void>(reported->write(testPayload(100, 0)));
        return ear.size() > 0;
    }));
    std::this_thread::sleep_for(100ms);  // nothing waits any more
    const std::size_t before = ear.size();
    // 0.6 s of a stream of 100 Hz, as a thread writes them that did not get the processor for so long.
    for (std::uint32_t i = 1; i <= 60; ++i) ASSERT_TRUE(reported->write(testPayload(500, i)));
    EXPECT_TRUE(waitUntil([&] { return ear.size() == before + 60; })) << ear.size() - before << " of 60";
}

TEST(Flow, IsWithoutLimitOnTheLoopbackDevice) {
    const TestDomain domain;
    const auto station = nodeIn(domain, {.interfaces = {"lo"}});
    std::atomic<int> received = 0;
    const auto listening =
        must(station->subscribe({"/k/left", TestType, bestEffort(), Lane::Large}, [&](auto) { ++received; }));
    // 2.5 MB a second; the limit for pictures would be 0.47.
    const ChildProcess talker(program("dds_peer"),
                              {"talk", std::to_string(domain.number()), "/k/left", "reliable=0", "size=50000",
                               "period=20", "interface=lo", "flow=" + std::to_string(Pictures)});
    ASSERT_TRUE(waitUntil([&] { return received > 5; }));
    const auto before = listening->counts();
    ASSERT_TRUE(waitUntil([&] { return listening->counts().samples > before.samples + 100; }));
    EXPECT_EQ(listening->counts().lost, before.lost);
}

}  // namespace
}  // namespace leitstand::test
