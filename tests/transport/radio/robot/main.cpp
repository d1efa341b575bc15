// radio_robot DOMAIN NAME SECONDS KEY=VALUE...: a robot's streams at the rates and sizes of design section 4,
// and how late its commands come. The streams begin when somebody listens to the points and end after
// SECONDS.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/dds/samples.h"

namespace {

using namespace leitstand;
using Clock = std::chrono::steady_clock;

std::atomic<bool> stopped = false;

struct Stream {
    std::string topic;
    Qos qos;
    Flow flow = Flow::Telemetry;
    std::size_t bytes = 0;
    double rate = 0.0;  // [Hz]
    std::unique_ptr<Publisher> publisher = {};
    std::uint32_t written = 0;
};

/// About 2.8 Mbit/s: half of the budget of both robots.
std::vector<Stream> streams(bool transientPoints) {
    const Qos bestEffort{.reliability = Qos::Reliability::BestEffort, .depth = 5};
    Qos points{.depth = 600};
    if (transientPoints) points.durability = Qos::Durability::TransientLocal;
    std::vector<Stream> all;
    all.push_back({"points", points, Flow::Scans, 13'750, 10.0});
    all.push_back({"odom", bestEffort, Flow::Telemetry, 720, 25.0});
    all.push_back({"imu", bestEffort, Flow::Telemetry, 340, 25.0});
    all.push_back({"tf", bestEffort, Flow::Telemetry, 160, 20.0});
    all.push_back({"left/image/compressed", bestEffort, Flow::Pictures, 15'000, 5.0});
    all.push_back({"ir/image/compressed", bestEffort, Flow::Pictures, 8'300, 9.0});
    all.push_back({"omni/image/compressed", bestEffort, Flow::Pictures, 15'600, 2.0});
    return all;
}

/// Writes each stream at its rate, in one thread, until @p end.
void play(std::vector<Stream>& all, Clock::time_point end) {
    const auto start = Clock::now();
    while (!stopped && Clock::now() < end) {
        auto next = end;
        for (Stream& stream : all) {
            const auto due = [&] {
                return start + std::chrono::duration_cast<Clock::duration>(
                                   std::chrono::duration<double>(stream.written / stream.rate));
            };
            if (due() <= Clock::now()) {
                const auto reported =
                    stream.publisher->write(test::testPayload(stream.bytes, ++stream.written));
                if (!reported) return static_cast<void>(std::fputs(reported.error().text.c_str(), stderr));
            }
            next = std::min(next, due());
        }
        std::this_thread::sleep_until(next);
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    std::signal(SIGTERM, [](int) { stopped = true; });
    NodeSettings settings;
    settings.domain = std::stoi(argv[1]);
    settings.name = argv[2];
    bool transientPoints = false;
    for (int i = 4; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "transient") transientPoints = true;
        if (word.starts_with("lease=")) settings.lease = std::stod(word.substr(6));
    }
    auto node = Node::create(settings);
    if (!node) return std::puts(node.error().text.c_str()), 1;
    std::mutex mutex;
    std::vector<double> delays;  // of commands [ms]
    const std::string prefix = "/" + settings.name + "/";
    auto commands =
        (*node)->subscribe({prefix + "cmd_vel", "std_msgs/msg/String", Qos{}}, [&](ReceivedSample sample) {
            const std::chrono::duration<double, std::milli> delay = sample.event.received - sample.sourceTime;
            const std::scoped_lock lock(mutex);
            delays.push_back(delay.count());
        });
    auto all = streams(transientPoints);
    for (Stream& stream : all) {
        auto made =
            (*node)->publisher({prefix + stream.topic, "std_msgs/msg/String", stream.qos, stream.flow});
        if (!commands || !made) return 1;
        stream.publisher = std::move(made).value();
    }
    const auto nap = [] { std::this_thread::sleep_for(std::chrono::milliseconds(2)); };
    while (!stopped && all.front().publisher->matched() == 0) nap();
    std::puts("begin");
    std::fflush(stdout);
    play(all, Clock::now() + std::chrono::seconds(std::stoi(argv[3])));
    {
        const std::scoped_lock lock(mutex);
        std::sort(delays.begin(), delays.end());
        const std::size_t count = delays.size();
        std::printf("points %u odom %u commands %zu p50 %.1f p99 %.1f worst %.1f\nend\n", all[0].written,
                    all[1].written, count, count > 0 ? delays[count / 2] : 0.0,
                    count > 0 ? delays[count * 99 / 100] : 0.0, count > 0 ? delays.back() : 0.0);
    }
    std::fflush(stdout);
    while (!stopped) nap();
    return 0;
}
