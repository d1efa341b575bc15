#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/link/link_monitor.h"
#include "core/robot/robot_description.h"
#include "transport/dds/node.h"

namespace leitstand {

/// How a link is watched.
struct LinkClientSettings {
    std::string station = "leitstand";           ///< persistent identity, told in the pings
    std::chrono::milliseconds pingEvery{500};    ///< 0: never
    std::chrono::milliseconds statusEvery{200};  ///< how often the status is judged and told
    LinkRules rules = {};
};

/// Called on the client's own thread or on the node's, which they must not hold up. Not after the client is
/// gone. They may not destroy it.
struct LinkListener {
    std::function<void(const LinkStatus&)> onStatus;  ///< every statusEvery
    std::function<void(const LinkStatus&)> onState;   ///< when the state changed; before onStatus
    std::function<void(ClockOffsetSample)>
        onClockOffset;  ///< when it changed, at most once a second: for the log
    std::function<void(const ReceivedSample&)> onPong;  ///< every sample of the pong topic, also bad ones
    std::function<void(const RawEvent&)> onPing;        ///< every ping that was sent
};

/// Watches the link to one robot: sends it pings, listens to their answers, and is handed what else comes
/// from it. A robot that answers no pings is watched by its samples alone. Any thread.
class LinkClient {
public:
    /// Errors name the robot's topic: its ping or pong has a type that is none.
    [[nodiscard]] static Result<std::unique_ptr<LinkClient>> create(Node& node, const RobotDescription& robot,
                                                                    const LinkClientSettings& settings = {},
                                                                    LinkListener listener = {});
    ~LinkClient();
    LinkClient(const LinkClient&) = delete;
    LinkClient& operator=(const LinkClient&) = delete;

    /// A sample of the robot, as soon as it was received: all that its streams bring, but for the pong topic,
    /// which the client listens to itself (handed over too, they are passed by). Never waits, never
    /// allocates.
    void onSample(const ReceivedSample& sample);
    /// The station switched a stream off (or on again): its silence is no fault.
    void setPaused(std::string_view topic, bool paused);
    /// As of now.
    [[nodiscard]] LinkStatus status() const;
    [[nodiscard]] std::uint64_t brokenPongs() const;  ///< answers that could not be read

private:
    struct State;
    explicit LinkClient(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
