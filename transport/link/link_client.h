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

/// How a link is watched.
struct LinkClientSettings {
    std::string station = "leitstand";           ///< persistent identity, sent in the pings
    std::chrono::milliseconds pingEvery{500};    ///< 0: never
    std::chrono::milliseconds statusEvery{200};  ///< how often the status is judged and reported
    LinkRules rules = {};
};

/// Callbacks on the client's own thread or on the node's. They must not block, and must not destroy the
/// client. None runs after the client is gone.
struct LinkListener {
    std::function<void(const LinkStatus&)> onStatus;  ///< every statusEvery
    std::function<void(const LinkStatus&)> onState;   ///< when the state changed; before onStatus
    std::function<void(ClockOffsetSample)>
        onClockOffset;  ///< when it changed, at most once a second: for the log
    std::function<void(const ReceivedSample&)> onPong;  ///< every sample of the pong topic, also bad ones
    std::function<void(const RawEvent&)> onPing;        ///< every ping that was sent
};

/// Watches the link to one robot: sends pings, receives their answers, and takes the robot's other samples
/// (onSample()). A robot that answers no pings is watched by its samples alone. Any thread.
class LinkClient {
public:
    /// Errors name the robot's topic: the type of its ping is wrong, or the node may not use it.
    [[nodiscard]] static Result<std::unique_ptr<LinkClient>> create(Node& node, const RobotDescription& robot,
                                                                    const LinkClientSettings& settings = {},
                                                                    LinkListener listener = {});
    ~LinkClient();
    LinkClient(const LinkClient&) = delete;
    LinkClient& operator=(const LinkClient&) = delete;

    /// Takes a sample of any of the robot's streams, as soon as it was received. Ignores samples of the pong
    /// topic, which the client receives itself. Never waits, never allocates.
    void onSample(const ReceivedSample& sample);
    /// Notes that the station switched a stream off: its silence is no fault until the stream is switched on
    /// again.
    void setPaused(std::string_view topic, bool paused);
    /// Returns the status as of now.
    [[nodiscard]] LinkStatus status() const;
    [[nodiscard]] std::uint64_t brokenPongs() const;  ///< answers that could not be read

private:
    struct State;
    explicit LinkClient(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
