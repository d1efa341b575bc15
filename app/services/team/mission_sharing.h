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

/// What a MissionSharing works with; may be called on any thread.
struct MissionSharingSetup {
    std::string station;                                ///< persistent identity
    std::filesystem::path folder;                       ///< of the mission: key scans are read from it
    std::function<bool()> holdsMap = {};                ///< whether this station makes the map
    std::function<bool(std::uint64_t)> isAdopted = {};  ///< whether a key scan came from another station
    std::function<bool()> sharesMap = {};  ///< whether our finds lie in the map that other stations know
    std::function<RobotsInMapPtr()> robots = {};          ///< never null
    std::function<void(const std::string&)> notify = {};  ///< for the operator, in words
};

/// Publishes on station_topic what this station decides, finds and maps, so that other stations show it
/// (docs/stations.md). Publishes each entry as it enters the log, and everything that counts now to stations
/// that come later. Publishes nothing while nobody listens. After an undo it publishes what counts instead,
/// because event numbers are each log's own. Any thread; node and mission outlive it.
class MissionSharing : public EventSink {
public:
    MissionSharing(Node& node, LiveMission& mission, MissionSharingSetup setup);
    ~MissionSharing() override;  ///< as close()

    /// Takes an event of the log.
    void onEvent(const Event& event) override;
    /// Publishes a change of the operator to the clock or to the mission's description.
    void publish(const Sample& sample, std::string_view topic);
    /// Checks who listens and who makes the map; call it when either may have changed.
    void look();
    /// Publishes all finds again: from now on they lie in a map that other stations know, too.
    void publishFindsAgain();
    void close() override;  ///< drops waiting work

private:
    void submit(const Sample& sample, std::string_view topic);
    void write(const Sample& sample, std::string_view topic);
    void write(const Payload& cdr, std::string_view topic);
    /// All key scans of the log, published a few at a time.
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
    std::map<std::string, std::unique_ptr<Publisher>, std::less<>> m_publishers;  ///< by topic; fixed
    mutable std::mutex m_mutex;
    std::set<Guid> m_listeners;    ///< readers of any shared topic; under the mutex
    std::set<Guid> m_scanReaders;  ///< those of key scans; under the mutex
    bool m_heldMap = false;        ///< under the mutex
    JobQueue m_jobs;
    std::jthread m_thread;  ///< last: joined first
};

}  // namespace leitstand
