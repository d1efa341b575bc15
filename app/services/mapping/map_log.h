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
    double largest = 0.0;  ///< by how far the newest one moved scans, at most [m]
};

/// What a map log needs.
struct MapLogSetup {
    std::string station;                             ///< persistent identity
    std::map<std::string, std::string> titles;       ///< of robots, for people, by name
    MapCrop usualCrop;                               ///< used while the mission holds none
    std::function<void(const std::string&)> notify;  ///< notifies the operator, in words
};

/// Connects a station's mapping with the mission's log. Publishes the results of the mapping in the log, and
/// makes the mapping follow what this and other stations publish there. Any thread, unless a method states
/// otherwise.
class MapLog {
public:
    /// @p mission must outlive it. Before follow() only functions that publish, and crop(), may be called.
    MapLog(LiveMission& mission, MapLogSetup setup);
    /// Sets the mapping that follows the log; @p mapping must outlive all calls of onEvent() and
    /// whenSettled().
    void follow(LiveMapping& mapping) { m_mapping = &mapping; }

    /// Publishes @p sample in the log, which returns it to onEvent(). Tasks of whenSettled() wait for that.
    /// Error when the log cannot take it.
    Result<void> publish(const Sample& sample, std::string_view topic);
    /// As publish(); notifies the operator of an error.
    void publishOrNotify(const Sample& sample, std::string_view topic);

    /// Publish results of the mapping; on its thread.
    void publish(const MapUpdate& update);
    void publishLoop(const ScanLinksSample& loop);
    void publish(const Settled& settled);
    void publish(const RobotPlaceSample& place);
    void publish(ScanBodiesSample bodies);
    /// Records that the operator moved a part of the map: the operator is notified how far scans move when
    /// the map is solved next. On the mapping's thread.
    void movedByHand() { m_loopClosed = true; }

    /// Takes an event of a station, from the mission's thread.
    void onEvent(const Event& event);

    /// Calls @p task on the mapping's thread once the log has all that was published before.
    void whenSettled(std::function<void(LiveMapper&)> task);
    /// Whether the log has returned all that was published, and no task waits.
    [[nodiscard]] bool isSettled() const;

    /// Publishes @p crop, valid from @p at on. Errors as of publish().
    Result<void> setCrop(const MapCrop& crop, Time at);
    [[nodiscard]] MapCrop crop() const;  ///< as requested last
    [[nodiscard]] ClosedLoops closedLoops() const;
    [[nodiscard]] const std::string& titleOf(
        const std::string& robot) const;  ///< title of @p robot, else its name

private:
    /// Publishes a sample that no task waits for.
    void publishAside(const Sample& sample, std::string_view topic);
    void onKeyScan(const KeyScanSample& scan);
    /// Takes what decides where scans lie, or what of them counts: links, poses, areas, and undos.
    void onDecision(const Event& event);
    /// Returns the area that the mapping has to follow now that @p event is in the log; empty: it has not
    /// changed.
    std::optional<MapCrop> changedCrop(const Event& event, const std::string& publisher);
    void runSettled(LiveMapper& mapper);
    [[nodiscard]] MapCrop cropInLog() const;

    LiveMission& m_mission;
    const MapLogSetup m_setup;
    LiveMapping* m_mapping = nullptr;
    bool m_loopClosed = false;  ///< the next poses are to be reported; of the mapping's thread
    bool m_closedByItself =
        false;  ///< they follow from a loop that nobody decided on; of the mapping's thread
    std::map<std::string, bool> m_certain;  ///< whether a robot's place was certain; of the mapping's thread
    mutable std::mutex m_mutex;             ///< guards the following
    MapCrop m_crop;
    bool m_cropMoved = false;  ///< the mapping does not know the log's area yet
    ClosedLoops m_closed;
    /// Numbers of samples that were published and that came back: the mission's state has all once they are
    /// equal.
    std::uint64_t m_published = 0, m_received = 0;
    std::set<std::uint64_t> m_registered;  ///< key scans that were published and have not come back yet
    std::deque<std::function<void(LiveMapper&)>> m_settled;  ///< tasks of whenSettled()
};

}  // namespace leitstand
