#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "app/services/log/live_mission.h"
#include "core/base/result.h"

namespace leitstand {

class Node;
class Subscription;
struct ReceivedSample;

/// Statistics of a topic that is received.
struct RecordedTopic {
    std::string name, type;
    /// Lost: number of samples that never arrived, from the writers' sequence numbers.
    std::uint64_t samples = 0, lost = 0;
    int writers = 0;  ///< number of writers at present
};

/// Subscribes to topics of a domain for a mission. Samples are passed to a tap, and then to the mission. Any
/// thread; node and mission must outlive the feed.
class MissionFeed {
public:
    /// Called on the node's threads, before the mission gets the sample. Must not block them.
    using Tap = std::function<void(const ReceivedSample&)>;
    /// Receives samples instead of the mission, and decides which of them the mission gets. Called on the
    /// node's threads.
    using Gate = std::function<void(ReceivedSample)>;
    /// Whether topics with stations' commands to robots are received as well.
    enum class Commands : std::uint8_t { Left, Received };

    MissionFeed(Node& node, LiveMission& mission, Tap tap = {});
    ~MissionFeed();  ///< does the same as end()
    MissionFeed(const MissionFeed&) = delete;
    MissionFeed& operator=(const MissionFeed&) = delete;

    /// Subscribes to a topic, and announces it to the mission. Does nothing if it is already subscribed. If
    /// there is a @p gate, it receives the samples instead of the mission.
    Result<void> listen(const std::string& topic, const std::string& type, const Qos& qos,
                        const Gate& gate = {});
    /// Subscribes to all topics of @p robot that its file marks for recording. Returns a text for each topic
    /// that cannot be received.
    std::vector<std::string> listenTo(const RobotDescription& robot, Commands commands = Commands::Left);
    /// Subscribes to what stations publish to each other, except what refers to their own logs. Returns a
    /// text for each topic that cannot be received.
    std::vector<std::string> listenToStations(const Gate& gate = {});

    [[nodiscard]] std::vector<RecordedTopic> topics() const;  ///< by name
    void end();  ///< when it has returned, no more samples are passed on

private:
    struct Listening {
        std::string type;
        std::unique_ptr<Subscription> subscription;
    };
    Node& m_node;
    LiveMission& m_mission;
    const Tap m_tap;
    mutable std::mutex m_mutex;
    std::map<std::string, Listening> m_topics;  ///< by name
};

}  // namespace leitstand
