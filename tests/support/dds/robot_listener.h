#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"
#include "tests/support/wait.h"
#include "transport/convert/decode.h"
#include "transport/dds/node.h"

namespace leitstand::test {

/// A sample as a station decodes it.
struct Received {
    Sample sample;
    Time received{};                   ///< this computer's clock
    std::uint64_t writerSequence = 0;  ///< as of ReceivedSample
};

/// Hears streams of a robot as a station does: by its file.
class RobotListener {
public:
    /// Listens to all of @p robot's streams that are no commands; throws when it cannot.
    RobotListener(Node& node, const RobotDescription& robot) {
        for (const StreamDescription& stream : robot.streams) {
            if (!isCommand(stream.role)) add(node, stream);
        }
    }
    RobotListener(Node& node, const std::vector<StreamDescription>& streams) {
        for (const StreamDescription& stream : streams) add(node, stream);
    }
    ~RobotListener() {
        for (const auto& one : m_streams) one->subscription.reset();
    }
    RobotListener(const RobotListener&) = delete;
    RobotListener& operator=(const RobotListener&) = delete;

    /// What came on @p topic so far; of a topic that it does not listen to, nothing.
    [[nodiscard]] std::vector<Received> on(const std::string& topic) const {
        const std::scoped_lock lock(m_mutex);
        const One* one = find(topic);
        return one == nullptr ? std::vector<Received>() : one->gotSample;
    }
    [[nodiscard]] std::size_t count(const std::string& topic) const {
        const std::scoped_lock lock(m_mutex);
        const One* one = find(topic);
        return one == nullptr ? 0 : one->gotSample.size();
    }
    template <class Kind>
    [[nodiscard]] std::vector<Kind> all(const std::string& topic) const {
        std::vector<Kind> found;
        for (const Received& gotSample : on(topic)) {
            if (const auto* one = gotSample.sample.as<Kind>()) found.push_back(*one);
        }
        return found;
    }
    [[nodiscard]] bool receives(const std::string& topic, std::size_t atLeast = 1,
                                std::chrono::seconds atMost = std::chrono::seconds(60)) const {
        return waitUntil([&] { return count(topic) >= atLeast; }, atMost);
    }
    /// What made no sense.
    [[nodiscard]] std::vector<std::string> errors() const {
        const std::scoped_lock lock(m_mutex);
        return m_errors;
    }

private:
    struct One {
        StreamDescription stream;
        std::vector<Received> gotSample;
        std::unique_ptr<Subscription> subscription;
    };
    void add(Node& node, const StreamDescription& stream) {
        m_streams.push_back(std::make_unique<One>());
        One& one = *m_streams.back();
        one.stream = stream;
        auto made = node.subscribe({stream.topic, stream.type, stream.qos, Lane::Small},
                                   [this, &one](const ReceivedSample& sample) { receive(one, sample); });
        if (!made) throw std::runtime_error(made.error().text);
        one.subscription = std::move(made).value();
    }
    void receive(One& one, const ReceivedSample& sample) {
        auto decoded = decode(sample.event, one.stream);
        const std::scoped_lock lock(m_mutex);
        if (!decoded) return m_errors.push_back(decoded.error().text);
        one.gotSample.push_back({std::move(decoded).value(), sample.event.received, sample.writerSequence});
    }
    [[nodiscard]] const One* find(const std::string& topic) const {
        for (const auto& one : m_streams) {
            if (one->stream.topic == topic) return one.get();
        }
        return nullptr;
    }

    mutable std::mutex m_mutex;
    std::vector<std::string> m_errors;
    std::vector<std::unique_ptr<One>> m_streams;  ///< last: their subscriptions call back
};

}  // namespace leitstand::test
