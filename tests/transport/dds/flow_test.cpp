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
    std::atomic<int> heard = 0;
    const auto listening =
        must(station->subscribe({"/k/left", TestType, bestEffort(), Lane::Large}, [&](auto) { ++heard; }));
    const ChildProcess talker(program("dds_peer"),
                              {"talk", std::to_string(domain.number()), "/k/left", "reliable=0", "size=13000",
                               "period=60", "flow=" + std::to_string(Pictures)});
    ASSERT_TRUE(waitUntil([&] { return heard > 5; }));
    const auto before = listening->counts();
    const Hindered hindered(talker, 3ms, 9ms);
    std::this_thread::sleep_for(5s);  // is what is measured
    const auto after = listening->counts();
    EXPECT_GT(after.samples - before.samples, 40U);
    EXPECT_EQ(after.lost, before.lost) << "of " << after.samples - before.samples;
}

TEST(Flow, IsWithoutLimitOnTheLoopbackDevice) {
    const TestDomain domain;
    const auto station = nodeIn(domain, {.interfaces = {"lo"}});
    std::atomic<int> heard = 0;
    const auto listening =
        must(station->subscribe({"/k/left", TestType, bestEffort(), Lane::Large}, [&](auto) { ++heard; }));
    // 2.5 MB a second; the limit for pictures would be 0.47.
    const ChildProcess talker(program("dds_peer"),
                              {"talk", std::to_string(domain.number()), "/k/left", "reliable=0", "size=50000",
                               "period=20", "interface=lo", "flow=" + std::to_string(Pictures)});
    ASSERT_TRUE(waitUntil([&] { return heard > 5; }));
    const auto before = listening->counts();
    ASSERT_TRUE(waitUntil([&] { return listening->counts().samples > before.samples + 100; }));
    EXPECT_EQ(listening->counts().lost, before.lost);
}

}  // namespace
}  // namespace leitstand::test
