// A process beside the test: `dds_peer talk DOMAIN TOPIC KEY=VALUE...` or `dds_peer echo DOMAIN TOPIC`.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <map>
#include <string>
#include <thread>

#include "tests/support/dds/samples.h"

namespace {

using namespace leitstand;
using Options = std::map<std::string, std::string>;

std::atomic<bool> stopped = false;

int number(const Options& options, const std::string& key, int otherwise) {
    const auto found = options.find(key);
    return found == options.end() ? otherwise : std::stoi(found->second);
}

Qos qosOf(const Options& options) {
    Qos qos;
    qos.reliability =
        number(options, "reliable", 1) != 0 ? Qos::Reliability::Reliable : Qos::Reliability::BestEffort;
    qos.durability =
        number(options, "transient", 0) != 0 ? Qos::Durability::TransientLocal : Qos::Durability::Volatile;
    qos.depth = number(options, "depth", 10);
    return qos;
}

/// Writes testPayloads with seeds 1, 2, ... once a reader matched, `count` (0: until stopped), every `period`
/// ms.
int talk(Node& node, const std::string& topic, const Options& options) {
    const auto type = options.contains("type") ? options.at("type") : "std_msgs/msg/String";
    auto made = node.publisher({topic, type, qosOf(options), static_cast<Flow>(number(options, "flow", 0))});
    if (!made) return std::puts(made.error().text.c_str()), 1;
    auto publisher = std::move(made).value();
    const auto size = static_cast<std::size_t>(number(options, "size", 100));
    const auto count = static_cast<std::uint32_t>(number(options, "count", 0));
    std::puts("ready");
    std::fflush(stdout);
    while (number(options, "wait", 1) != 0 && !stopped && publisher->matched() == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    for (std::uint32_t i = 1; (count == 0 || i <= count) && !stopped; ++i) {
        if (!publisher->write(test::testPayload(size, i))) return 1;
        std::this_thread::sleep_for(std::chrono::milliseconds(number(options, "period", 10)));
    }
    while (!stopped) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return 0;
}

/// Sends what comes on TOPIC back on TOPIC/back.
int echo(Node& node, const std::string& topic, const Options& options) {
    const auto type = options.contains("type") ? options.at("type") : "std_msgs/msg/String";
    auto back = node.publisher({topic + "/back", type, qosOf(options), Flow::Immediate});
    if (!back) return 1;
    auto received = node.subscribe({topic, type, qosOf(options), Lane::Small}, [&](ReceivedSample sample) {
        static_cast<void>((*back)->write(sample.event.cdr));
    });
    if (!received) return 1;
    std::puts("ready");
    std::fflush(stdout);
    while (!stopped) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4) return 2;
    std::signal(SIGTERM, [](int) { stopped = true; });
    Options options;
    for (int i = 4; i < argc; ++i) {
        const std::string word = argv[i];
        options[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    }
    NodeSettings settings;
    settings.domain = std::stoi(argv[2]);
    settings.name = options.contains("name") ? options.at("name") : "peer";
    settings.multicast = number(options, "multicast", 1) != 0;
    settings.lease = number(options, "lease", 20);
    if (options.contains("peers")) settings.initialPeers = {options.at("peers")};
    if (options.contains("server")) settings.discoveryServer = options.at("server");
    if (options.contains("interface")) settings.interfaces = {options.at("interface")};
    for (FlowLimit* limit : {&settings.telemetryLimit, &settings.scanLimit, &settings.pictureLimit}) {
        limit->bytes = number(options, "limit", limit->bytes);
    }
    auto node = Node::create(settings);
    if (!node) return std::puts(node.error().text.c_str()), 1;
    const std::string what = argv[1];
    return what == "talk" ? talk(**node, argv[3], options) : echo(**node, argv[3], options);
}
