#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/dds/samples.h"
#include "tests/support/wait.h"
#include "tests/transport/dds/test_node.h"

namespace leitstand::test {

/// Has @p writer say something on several topics without end, while @p listener hears each @p rounds times
/// and goes again, being the only one: expects that it is heard each time. @p depth: of the writers'
/// histories, so many samples wait to be sent.
inline void expectOutlivesItsListeners(Node& writer, Node& listener, int rounds, int depth) {
    const std::array<std::string, 4> topics = {"/kurt3d/odom", "/kurt3d/imu", "/kurt3d/battery_state",
                                               "/kurt3d/joint_states"};
    std::vector<std::unique_ptr<Publisher>> publishers;
    for (const std::string& topic : topics)
        publishers.push_back(must(writer.publisher({topic, TestType, reliable(depth), Flow::Telemetry})));
    const std::jthread writing([&](const std::stop_token& over) {
        const Payload word = testPayload(20, 1);
        while (!over.stop_requested()) {
            for (const auto& publisher : publishers) static_cast<void>(publisher->write(word));
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    });
    for (int round = 0; round < rounds; ++round) {
        for (const std::string& topic : topics) {
            std::atomic<bool> received = false;
            const auto listening = must(listener.subscribe({topic, TestType, {}, Lane::Small},
                                                           [&](const ReceivedSample&) { received = true; }));
            ASSERT_TRUE(waitUntil([&] { return received.load(); })) << topic << ", round " << round;
        }
    }
}

}  // namespace leitstand::test
