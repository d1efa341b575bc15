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

/// How a topic is heard.
struct HeardTopic {
    std::string name, type;
    std::uint64_t samples = 0, lost = 0;  ///< lost: never arrived, by the writers' numbers
    int writers = 0;                      ///< that are there now
};

/// Hears topics of a domain for a mission: what comes goes to a tap, and from there into the mission. Any
/// thread; node and mission outlive it.
class MissionFeed {
public:
    /// Called on the node's threads, before the mission has the sample; must not hold them up.
    using Tap = std::function<void(const ReceivedSample&)>;
    /// Decides what of it enters the mission, on the node's threads.
    using Gate = std::function<void(ReceivedSample)>;
    /// Whether topics that stations command robots with are heard too.
    enum class Commands : std::uint8_t { Left, Heard };

    MissionFeed(Node& node, LiveMission& mission, Tap tap = {});
    ~MissionFeed();  ///< as end()
    MissionFeed(const MissionFeed&) = delete;
    MissionFeed& operator=(const MissionFeed&) = delete;

    /// Listens to a topic, and announces it to the mission; nothing when it does already. With a @p gate
    /// that gets what comes instead of the mission.
    Result<void> listen(const std::string& topic, const std::string& type, const Qos& qos,
                        const Gate& gate = {});
    /// Listens to all of @p robot's topics that its file wants recorded. Returns what cannot be heard, in
    /// words.
    std::vector<std::string> listenTo(const RobotDescription& robot, Commands commands = Commands::Left);
    /// Listens to what stations say to each other, but for what speaks of their own logs.
    std::vector<std::string> listenToStations(const Gate& gate = {});

    [[nodiscard]] std::vector<HeardTopic> topics() const;  ///< by name
    void end();                                            ///< nothing comes any more once it has returned

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
