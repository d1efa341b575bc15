#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/log/event_sink.h"
#include "app/services/mapping/map_log.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/loop_preview.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/map.h"
#include "core/mission/loops/open_loops.h"
#include "core/mission/state/undo.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct Event;
class LiveMission;
class StationScanners;

/// Functions that are called on threads of the station and must not block them. Each may be empty.
struct StationMappingListener {
    std::function<void(const std::string&)> onMessage = {};  ///< called with a text for the operator
    std::function<void(const MapPtr&)> onMap = {};  ///< called when the map grew or moved, for the map view
    std::function<void(const LiveMapPtr&)> onScans =
        {};  ///< called at the same time: all key scans, with their trust
};

/// What a station's map needs at the start.
struct StationMappingSetup {
    std::vector<RobotDescription> robots;
    std::string station;  ///< persistent identity
    LiveSettings settings;
    std::vector<KeyScanSample> earlier;           ///< key scans of the mission's earlier sessions ...
    std::vector<ScanLinksSample> earlierLinks{};  ///< ... and the links to what they were registered against
    std::filesystem::path mission{};  ///< folder of the mission, in which the robots' files are kept
};

/// The map of a station with live robots, and the operator's decisions about its scans. Results and decisions
/// are written to the mission's log, and the map follows when they return from the log. Only the station that
/// holds the map's grant registers scans and decides. While this station does not hold it, the scans of the
/// newest ten seconds wait. Any thread; no call waits for the mapping, so later errors are reported as
/// messages.
class StationMapping : public EventSink {
public:
    /// @p mission must exist until close(). @p mayMap: returns whether the station holds the map's grant.
    StationMapping(LiveMission& mission, std::function<bool()> mayMap, StationMappingSetup setup,
                   StationMappingListener listener);
    ~StationMapping() override;

    void close() override;  ///< as LiveMapping::close()
    /// Calls @p done on the mapping's thread when all waiting work is done and no poses are being solved. If
    /// the mapping ends before that, it is not called. Does not wait for work that itself waits for the log.
    void whenCalm(std::function<void()> done);
    /// Call with all events of the mission, in order, on its thread.
    void onEvent(const Event& event) override;

    /// Decisions about key scans (docs/live-mapping.md). Errors, in words: another station has the map, the
    /// map has no such scan, or there is nothing to decide.
    Result<void> accept(std::uint64_t scan);
    Result<void> reject(std::uint64_t scan);
    Result<void> retry(std::uint64_t scan, const RetrySettings& settings = {});
    Result<void> rewind(Time moment);  ///< @p moment: station's clock
    Result<void> undo();               ///< undoes this station's newest decision or area that is not undone
    Result<void> redo();               ///< redoes what was undone last
    /// Publishes @p undo, which undoes something of this station that is no decision about the map, such as a
    /// find. Every undo of this station must be published here, since the log of the map counts them.
    Result<void> takeBack(const UndoSample& undo);
    /// Proposes that the key scan @p scan was taken at about @p scanInMap. Compares it with what an older
    /// part of the map shows there. If the two fit, openLoop() asks whether they are the same place.
    /// Otherwise the listener is notified.
    Result<void> propose(std::uint64_t scan, const Pose& scanInMap);
    /// Moves the submapOf() @p scan as the operator dragged it, so that this scan was taken at @p scanInMap.
    /// Links its scans with those that they overlap with, and the map follows. undo() undoes this. Calls
    /// @p done on the mapping's thread with the number of links, or with the reason why there are none.
    /// Errors, in words: another station has the map, or the map has no such scan.
    Result<void> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                        std::function<void(Result<std::size_t>)> done);
    /// Answers @p asked, which is openLoop() of the mission. @p same: the two are the same place, and the map
    /// is joined there. Otherwise they are not, and the question is not asked again. undo() undoes the
    /// answer. Errors, in words: another station has the map, or by now there is another question or none.
    Result<void> answerLoop(const OpenLoop& asked, bool same);
    /// Returns how the map would become if @p asked were answered with "the same place". It is computed on
    /// another thread: null until the first result, then the newest result while the map continues to change.
    /// Only results of the newest question are kept.
    [[nodiscard]] LoopPreviewPtr preview(const OpenLoop& asked);
    /// Undoes the newest loop closure in the map, no matter who made it. Scans return to the poses that the
    /// other links give them. The loop does not close there automatically again.
    Result<void> undoLoop();
    [[nodiscard]] std::optional<MapDecision> loop() const;  ///< the loop closure that undoLoop() would undo
    [[nodiscard]] ClosedLoops closedLoops() const;
    /// What undo() and redo() would undo or redo, according to the present log; empty: nothing.
    [[nodiscard]] std::optional<MapDecision> undoable() const;
    [[nodiscard]] std::optional<MapDecision> redoable() const;

    /// Whether the station makes the map, and decides about it.
    [[nodiscard]] bool makesMap() const;

    /// Sets the area that belongs to the map, also for scans that are already in it. It is logged, can be
    /// undone like decisions, and is kept when the station restarts. Error when another station has the map.
    Result<void> setCrop(const MapCrop& crop);
    [[nodiscard]] MapCrop crop() const;

    /// Places @p robot (base_link) roughly at @p baseInMap, as the operator says. What its laser or its next
    /// 3D scan sees is looked for around there. A robot that certainly is in another part of the map is not
    /// moved: its newest key scan is proposed there, as by propose(). Without this call, a robot is placed
    /// automatically beside the robot that makes the map. The result is seen in robots() and is reported as a
    /// message.
    Result<void> place(const std::string& robot, const Pose& baseInMap);
    /// Looks for @p robot in the map by its newest 3D scan, and places it where it is found
    /// (LostRobots::lookFor()). Its next scan shows whether this is right. The listener is notified of the
    /// result.
    Result<void> lookFor(const std::string& robot);

    /// The scanners that make the map, and the errors that it shows of them.
    [[nodiscard]] StationScanners& scanners() const;

    [[nodiscard]] LiveMapPtr scans() const;       ///< never null
    [[nodiscard]] RobotsInMapPtr robots() const;  ///< present places of the robots; never null

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
