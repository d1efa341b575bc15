#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>

#include "app/services/job_queue.h"
#include "app/services/log/event_sink.h"
#include "app/services/log/live_mission.h"
#include "core/mapping/live/robot_in_map.h"
#include "transport/dds/node.h"

namespace leitstand {

class Sample;
struct UndoSample;
struct Event;

/// What a MissionSharing needs. Its functions may be called on any thread.
struct MissionSharingSetup {
    std::string station;                  ///< persistent identity
    std::filesystem::path folder;         ///< folder of the mission, from which key scans are read
    std::function<bool()> holdsMap = {};  ///< returns whether this station makes the map
    /// Returns whether a key scan came from another station.
    std::function<bool(std::uint64_t)> isAdopted = {};
    /// Returns whether this station's finds are in the map that other stations know.
    std::function<bool()> sharesMap = {};
    std::function<RobotsInMapPtr()> robots = {};          ///< its result is never null
    std::function<void(const std::string&)> notify = {};  ///< called with a text for the operator
};

/// Publishes on station_topic what this station decides, finds and maps, so that other stations show it
/// (docs/stations.md). Publishes each entry when it enters the log. A station that joins later gets
/// everything that is valid at that time. Publishes nothing while nobody subscribes. After an undo it
/// publishes what is valid instead, since event numbers have a meaning only within one log. Any thread; node
/// and mission outlive it.
class MissionSharing : public EventSink {
public:
    MissionSharing(Node& node, LiveMission& mission, MissionSharingSetup setup);
    ~MissionSharing() override;  ///< does the same as close()

    /// Takes an event of the log.
    void onEvent(const Event& event) override;
    /// Publishes a change that the operator made to the clock or to the mission's description.
    void publish(const Sample& sample, std::string_view topic);
    /// Checks who subscribes and who makes the map. Call when either may have changed.
    void look();
    /// Publishes all finds again, because they are now in a map that other stations know as well.
    void publishFindsAgain();
    void close() override;  ///< discards waiting work

private:
    void submit(const Sample& sample, std::string_view topic);
    void write(const Sample& sample, std::string_view topic);
    void write(const Payload& cdr, std::string_view topic);
    /// All key scans of the log, which are published a few at a time.
    struct Publishing;
    void publishAll(const std::stop_token& stop);
    void publishScans(std::shared_ptr<Publishing> publishing, const std::stop_token& stop);
    void publishRest();
    [[nodiscard]] std::shared_ptr<Publishing> scansToPublish();
    void publishMap(const MissionState& mission);
    void publishFinds(const MissionState& mission);
    void publishClock(const MissionState& mission);
    void notifyUndone(const UndoSample& undo);
    [[nodiscard]] bool isReceived() const;

    Node& m_node;
    LiveMission& m_mission;
    const MissionSharingSetup m_setup;
    std::map<std::string, std::unique_ptr<Publisher>, std::less<>> m_publishers;  ///< by topic; not changed
    mutable std::mutex m_mutex;
    std::set<Guid> m_listeners;    ///< subscribers of any shared topic; under the mutex
    std::set<Guid> m_scanReaders;  ///< subscribers of key scans; under the mutex
    bool m_heldMap = false;        ///< under the mutex
    JobQueue m_jobs;
    std::jthread m_thread;  ///< the last member, so that it is joined first
};

}  // namespace leitstand
