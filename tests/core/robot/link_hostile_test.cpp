#include <chrono>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "core/event/status_samples.h"
#include "tests/core/robot/link_scene.h"

namespace leitstand::test {
namespace {

using namespace std::chrono_literals;

/// What a time on the wire can be: seconds of 32 bits.
Time anyTime(std::mt19937& random) {
    switch (random() % 4) {
        case 0:
            return Time{};
        case 1:
            return Time(std::chrono::seconds(std::numeric_limits<std::int32_t>::min()));
        case 2:
            return Time(std::chrono::seconds(std::numeric_limits<std::int32_t>::max()) + 999'999'999ns);
        default:
            return Time(std::chrono::seconds(static_cast<std::int32_t>(random())));
    }
}

std::uint64_t anyNumber(std::mt19937& random) {
    return random() % 2 == 0 ? random() % 100 : ~std::uint64_t{0} - random() % 3;
}

TEST(LinkHostile, NoTimesAndNumbersUpsetTheMonitor) {  // the sanitizers look on
    for (unsigned seed = 1; seed <= 20; ++seed) {
        std::mt19937 random(seed);
        const RobotDescription robot = linkedRobot();
        LinkMonitor monitor(robot);
        SteadyTime now(1000s);
        for (int i = 0; i < 5000; ++i) {
            now += std::chrono::milliseconds(random() % 50);
            const Time station = Time(1'700'000'000s) + (now.time_since_epoch());
            const auto& stream = robot.streams[random() % robot.streams.size()];
            const StreamArrival arrival{random() % 5 == 0 ? std::numeric_limits<std::uint32_t>::max() : 100U,
                                        {static_cast<std::uint8_t>(random() % 8)},
                                        anyNumber(random),
                                        anyTime(random),
                                        station};
            monitor.sample(stream.topic, arrival, now);
            monitor.ping(static_cast<std::uint64_t>(i), station, now);
            PongSample pong{static_cast<std::uint64_t>(i), "station", station, anyTime(random),
                            anyTime(random)};
            monitor.pong(pong, station + 20ms, now + 20ms);
            const LinkStatus link = monitor.status(now + 20ms);
            for (const StreamStatus& status : link.streams) {
                ASSERT_TRUE(std::isfinite(status.rate) && status.rate >= 0.0);
                ASSERT_TRUE(std::isfinite(status.megabitsPerSecond));
                ASSERT_GE(status.lossRatio, 0.0);
                ASSERT_LE(status.lossRatio, 1.0);
            }
            static_cast<void>(toString(link.reasons));
        }
    }
}

TEST(LinkHostile, RandomClocksNeverMakeTheBoundsEmpty) {
    std::mt19937 random(1);
    ClockOffset clock;
    SteadyTime now(1000s);
    for (int i = 0; i < 20'000; ++i) {
        now += 500ms;
        const Time station = Time(1'700'000'000s) + now.time_since_epoch();
        const Time robot = anyTime(random);
        clock.ping({station, robot, robot, station + 1ms}, now);
        const auto status = clock.status(now);
        ASSERT_TRUE(status);
        ASSERT_GE(status->uncertainty, 0ns);
    }
}

TEST(LinkCost, OfASampleIsSmall) {
    const RobotDescription robot = linkedRobot();
    LinkMonitor monitor(robot);
    constexpr int Samples = 300'000;
    StreamArrival arrival{1000, {1}, 0, {}, {}};
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 0; i < Samples; ++i) {
        const auto passed = std::chrono::microseconds(i * 100LL);
        ++arrival.sequence;
        arrival.written = arrival.received = Time(1'700'000'000s) + passed;
        monitor.sample("/kurt3d/odom", arrival, SteadyTime(1000s) + passed);
    }
    const std::chrono::duration<double, std::nano> took = std::chrono::steady_clock::now() - begin;
    std::printf("%.0f ns a sample\n", took.count() / Samples);
    EXPECT_LT(took.count() / Samples, 20'000.0);
}

}  // namespace
}  // namespace leitstand::test
