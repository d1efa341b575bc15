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
#include "core/event/event.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/robot_in_map.h"

namespace leitstand {

class LiveMapping;
class LiveMission;

/// Loops that closed by themselves since the station began.
struct ClosedLoops {
    std::uint64_t count = 0;
    double largest = 0.0;  ///< by which the newest one moved scans, at most [m]
};

/// What a map log belongs to.
struct MapLogSetup {
    std::string station;                             ///< persistent identity
    std::map<std::string, std::string> titles;       ///< of robots, for people, by name
    MapCrop usualCrop;                               ///< while the mission says nothing about it
    std::function<void(const std::string&)> notify;  ///< the operator, in words
};

/// A station's map in the mission's log: what the mapping comes to is published there, and the mapping
/// follows what the log has, ours and other stations'. Any thread, unless a method says otherwise.
class MapLog {
public:
    /// @p mission must outlive it. Before follow() nothing may be called but what publishes, and crop().
    MapLog(LiveMission& mission, MapLogSetup setup);
    /// @p mapping is what follows the log; it must outlive all calls of onEvent() and whenSettled().
    void follow(LiveMapping& mapping) { m_mapping = &mapping; }

    /// Publishes @p sample, which the log gives back to onEvent(): what whenSettled() was given waits until
    /// then. Errors: the log cannot take it.
    Result<void> publish(const Sample& sample, std::string_view topic);
    /// The same; the operator is notified of an error.
    void publishOrNotify(const Sample& sample, std::string_view topic);

    /// What the mapping comes to; on its thread.
    void publish(const MapUpdate& update);
    void publishLoop(const ScanLinksSample& loop);
    void publish(const Settled& settled);
    void publish(const RobotPlaceSample& place);
    void publish(ScanBodiesSample bodies);
    /// The operator has moved something of the map: what the poses that follow come to is told. On the
    /// mapping's thread.
    void movedByHand() { m_loopClosed = true; }

    /// An event of a station's, from the mission's thread.
    void onEvent(const Event& event);

    /// Calls @p task on the mapping's thread once the log has all that was published before.
    void whenSettled(std::function<void(LiveMapper&)> task);
    /// Whether it has, and nothing waits for it.
    [[nodiscard]] bool isSettled() const;

    /// Publishes @p crop, from @p at on. Errors: as publish().
    Result<void> setCrop(const MapCrop& crop, Time at);
    [[nodiscard]] MapCrop crop() const;  ///< as it was asked for last
    [[nodiscard]] ClosedLoops closedLoops() const;
    [[nodiscard]] const std::string& titleOf(const std::string& robot) const;  ///< its name where it has none

private:
    /// Publishes what nothing waits for.
    void publishAside(const Sample& sample, std::string_view topic);
    void onKeyScan(const KeyScanSample& scan);
    /// What decides where scans lie, or what of them counts: links, poses, areas, and what is taken back.
    void onDecision(const Event& event);
    /// The area that the mapping has to follow now that @p event is in the log; empty: none.
    std::optional<MapCrop> changedCrop(const Event& event, const std::string& publisher);
    void runSettled(LiveMapper& mapper);
    [[nodiscard]] MapCrop cropInLog() const;

    LiveMission& m_mission;
    const MapLogSetup m_setup;
    LiveMapping* m_mapping = nullptr;
    bool m_loopClosed = false;      ///< poses that follow it are not told yet; of the mapping's thread
    bool m_closedByItself = false;  ///< likewise, and nobody decided it
    std::map<std::string, bool> m_certain;  ///< whether a robot's place was; of the mapping's thread
    mutable std::mutex m_mutex;             ///< of the following
    MapCrop m_crop;
    bool m_cropMoved = false;  ///< the mapping does not know the log's area yet
    ClosedLoops m_closed;
    /// How much of what was published came back: only then the mission's state has all of it.
    std::uint64_t m_published = 0, m_received = 0;
    std::set<std::uint64_t> m_registered;  ///< key scans that were published and did not come back yet
    std::deque<std::function<void(LiveMapper&)>> m_settled;  ///< to be done then, on the mapping's thread
};

}  // namespace leitstand
