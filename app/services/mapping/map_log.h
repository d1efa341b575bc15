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

/// Loops that closed by themselves since the station began.
struct ClosedLoops {
    std::uint64_t count = 0;
    double largest = 0.0;  ///< how far the newest one moved scans, at most [m]
};

/// What a map log needs.
struct MapLogSetup {
    std::string station;                             ///< persistent identity
    std::map<std::string, std::string> titles;       ///< of robots, for people, by name
    MapCrop usualCrop;                               ///< used while the mission holds none
    std::function<void(const std::string&)> notify;  ///< notifies the operator, in words
};

/// A station's map in the mission's log. Publishes the results of the mapping there, and makes the mapping
/// follow the log, ours and other stations'. Any thread, unless a method states otherwise.
class MapLog {
public:
    /// @p mission must outlive it. Before follow() only functions that publish, and crop(), may be called.
    MapLog(LiveMission& mission, MapLogSetup setup);
    /// Sets the mapping that follows the log; @p mapping must outlive all calls of onEvent() and
    /// whenSettled().
    void follow(LiveMapping& mapping) { m_mapping = &mapping; }

    /// Publishes @p sample, which the log returns to onEvent(). Tasks of whenSettled() wait until then. Error
    /// when the log cannot take it.
    Result<void> publish(const Sample& sample, std::string_view topic);
    /// As publish(); notifies the operator of an error.
    void publishOrNotify(const Sample& sample, std::string_view topic);

    /// Publishes a result of the mapping; on its thread.
    void publish(const MapUpdate& update);
    void publishLoop(const ScanLinksSample& loop);
    void publish(const Settled& settled);
    void publish(const RobotPlaceSample& place);
    void publish(ScanBodiesSample bodies);
    /// Records that the operator moved something of the map: the effect of the poses that follow is reported.
    /// On the mapping's thread.
    void movedByHand() { m_loopClosed = true; }

    /// Takes an event of a station, from the mission's thread.
    void onEvent(const Event& event);

    /// Calls @p task on the mapping's thread once the log has all that was published before.
    void whenSettled(std::function<void(LiveMapper&)> task);
    /// Whether the log has all of it, and no task waits.
    [[nodiscard]] bool isSettled() const;

    /// Publishes @p crop, valid from @p at on. Errors as of publish().
    Result<void> setCrop(const MapCrop& crop, Time at);
    [[nodiscard]] MapCrop crop() const;  ///< as requested last
    [[nodiscard]] ClosedLoops closedLoops() const;
    [[nodiscard]] const std::string& titleOf(const std::string& robot) const;  ///< its name if it has none

private:
    /// Publishes a sample that no task waits for.
    void publishAside(const Sample& sample, std::string_view topic);
    void onKeyScan(const KeyScanSample& scan);
    /// Takes what decides where scans lie, or what of them counts: links, poses, areas, and undos.
    void onDecision(const Event& event);
    /// Returns the area that the mapping has to follow now that @p event is in the log; empty: none.
    std::optional<MapCrop> changedCrop(const Event& event, const std::string& publisher);
    void runSettled(LiveMapper& mapper);
    [[nodiscard]] MapCrop cropInLog() const;

    LiveMission& m_mission;
    const MapLogSetup m_setup;
    LiveMapping* m_mapping = nullptr;
    bool m_loopClosed = false;      ///< the next poses' effect is not reported yet; of the mapping's thread
    bool m_closedByItself = false;  ///< also, nobody decided it; of the mapping's thread
    std::map<std::string, bool> m_certain;  ///< whether a robot's place was certain; of the mapping's thread
    mutable std::mutex m_mutex;             ///< guards the following
    MapCrop m_crop;
    bool m_cropMoved = false;  ///< the mapping does not know the log's area yet
    ClosedLoops m_closed;
    /// Numbers of samples that were published and that came back: the mission's state has all once they are
    /// equal.
    std::uint64_t m_published = 0, m_received = 0;
    std::set<std::uint64_t> m_registered;  ///< key scans that were published and have not come back yet
    std::deque<std::function<void(LiveMapper&)>> m_settled;  ///< tasks to run then, on the mapping's thread
};

}  // namespace leitstand
