#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/event/scan_bodies.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/robot_in_map.h"

namespace leitstand {

class Sample;
struct Event;
class LiveMapping;
class LiveMission;

/// Loops that were closed automatically since the station started.
struct ClosedLoops {
    std::uint64_t count = 0;
    double largest = 0.0;  ///< largest move of a scan by the newest loop [m]
};

/// What a map log needs.
struct MapLogSetup {
    std::string station;                             ///< persistent identity
    std::map<std::string, std::string> titles;       ///< titles of robots for people, by name
    MapCrop usualCrop;                               ///< used as long as the mission has no area
    std::function<void(const std::string&)> notify;  ///< called with a text for the operator
};

/// Connects a station's mapping with the mission's log. Publishes the results of the mapping in the log, and
/// makes the mapping follow what this and other stations publish there. Any thread, unless a method says
/// otherwise.
class MapLog {
public:
    /// @p mission must outlive this object. Before follow(), only crop() and functions that publish may be
    /// called.
    MapLog(LiveMission& mission, MapLogSetup setup);
    /// Sets the mapping that follows the log; @p mapping must outlive all calls of onEvent() and
    /// whenSettled().
    void follow(LiveMapping& mapping) { m_mapping = &mapping; }

    /// Publishes @p sample in the log, which passes it back to onEvent(). Tasks of whenSettled() wait for
    /// that. Error when the log cannot take it.
    Result<void> publish(const Sample& sample, std::string_view topic);
    /// As publish(), but notifies the operator of an error.
    void publishOrNotify(const Sample& sample, std::string_view topic);

    /// Publish results of the mapping; call on its thread.
    void publish(const MapUpdate& update);
    void publishLoop(const ScanLinksSample& loop);
    void publish(const Settled& settled);
    void publish(const RobotPlaceSample& place);
    void publish(ScanBodiesSample bodies);
    /// Notes that the operator moved a part of the map. When the map is next solved, the operator is told how
    /// far scans moved. Call on the mapping's thread.
    void movedByHand() { m_loopClosed = true; }

    /// Takes an event of a station, from the mission's thread.
    void onEvent(const Event& event);

    /// Calls @p task on the mapping's thread when the log has everything that was published before.
    void whenSettled(std::function<void(LiveMapper&)> task);
    /// Whether the log has passed back everything that was published, and no task waits.
    [[nodiscard]] bool isSettled() const;

    /// Publishes @p crop, which is valid from @p at on. Errors are those of publish().
    Result<void> setCrop(const MapCrop& crop, Time at);
    [[nodiscard]] MapCrop crop() const;  ///< area that was requested last
    [[nodiscard]] ClosedLoops closedLoops() const;
    [[nodiscard]] const std::string& titleOf(
        const std::string& robot) const;  ///< title of @p robot; its name if it has none

private:
    /// Publishes a sample for which no task waits.
    void publishAside(const Sample& sample, std::string_view topic);
    void onKeyScan(const KeyScanSample& scan);
    /// Takes events that decide about the poses or points of scans: links, poses, areas, and undos.
    void onDecision(const Event& event);
    /// Returns the area that the mapping must use now that @p event is in the log; empty: it has not changed.
    std::optional<MapCrop> changedCrop(const Event& event, const std::string& publisher);
    void runSettled(LiveMapper& mapper);
    [[nodiscard]] MapCrop cropInLog() const;

    LiveMission& m_mission;
    const MapLogSetup m_setup;
    LiveMapping* m_mapping = nullptr;
    bool m_loopClosed = false;  ///< whether to report the next poses; used on the mapping's thread
    bool m_closedByItself =
        false;  ///< whether they result from a loop that nobody decided about; used on the mapping's thread
    /// Whether each robot's place was certain; used on the mapping's thread.
    std::map<std::string, bool> m_certain;
    mutable std::mutex m_mutex;  ///< guards the following
    MapCrop m_crop;
    bool m_cropMoved = false;  ///< whether the mapping does not know the log's area yet
    ClosedLoops m_closed;
    /// Number of samples that were published, and that came back. When they are equal, the mission's state
    /// includes all of them.
    std::uint64_t m_published = 0, m_received = 0;
    /// Ids of key scans that were published and have not come back yet.
    std::set<std::uint64_t> m_registered;
    std::deque<std::function<void(LiveMapper&)>> m_settled;  ///< tasks of whenSettled()
};

}  // namespace leitstand
