#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/event/station_samples.h"
#include "core/robot/link/link_monitor.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// How a link is monitored.
struct LinkClientSettings {
    std::string station = "leitstand";           ///< the station's persistent identity, sent in pings
    std::chrono::milliseconds pingEvery{500};    ///< time between pings; 0: none are sent
    std::chrono::milliseconds statusEvery{200};  ///< how often the status is judged and reported
    LinkRules rules = {};
};

/// Callbacks on the client's own thread or on the node's. They must not block, and must not destroy the
/// client. None runs after the client is destroyed.
struct LinkListener {
    std::function<void(const LinkStatus&)> onStatus;  ///< called every statusEvery
    std::function<void(const LinkStatus&)> onState;   ///< called when the state changed, before onStatus
    std::function<void(ClockOffsetSample)>
        onClockOffset;  ///< called when it changed, at most once a second, for the log
    /// Called with every sample on the pong topic, including bad ones.
    std::function<void(const ReceivedSample&)> onPong;
    std::function<void(const RawEvent&)> onPing;  ///< called with every ping that was sent
};

/// Monitors the link to one robot: sends pings, receives the answers, and takes the robot's other samples
/// (onSample()). If a robot does not answer pings, only its samples are used. Any thread.
class LinkClient {
public:
    /// Errors name the robot's topic: its ping has a wrong type, or the node may not use the topic.
    [[nodiscard]] static Result<std::unique_ptr<LinkClient>> create(Node& node, const RobotDescription& robot,
                                                                    const LinkClientSettings& settings = {},
                                                                    LinkListener listener = {});
    ~LinkClient();
    LinkClient(const LinkClient&) = delete;
    LinkClient& operator=(const LinkClient&) = delete;

    /// Takes a sample of any of the robot's streams as soon as it was received. Ignores samples of the pong
    /// topic, which the client receives itself. Never waits, never allocates.
    void onSample(const ReceivedSample& sample);
    /// Notes whether the station switched a stream off. While it is off, its silence is no fault.
    void setPaused(std::string_view topic, bool paused);
    /// Returns the status as of now.
    [[nodiscard]] LinkStatus status() const;
    [[nodiscard]] std::uint64_t brokenPongs() const;  ///< number of answers that could not be read

private:
    struct State;
    explicit LinkClient(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
