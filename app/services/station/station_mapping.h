#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/services/log/event_sink.h"
#include "app/services/mapping/map_log.h"
#include "app/services/mapping/scanner_advice.h"
#include "core/base/result.h"
#include "core/base/time.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/loop_preview.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/map.h"
#include "core/mission/loops/open_loops.h"
#include "core/mission/state/undo.h"

namespace leitstand {

struct Event;
class LiveMission;

/// Called on threads of the station, which they must not block; any may be empty.
struct StationMappingListener {
    std::function<void(const std::string&)> onMessage = {};  ///< for the operator, in words
    std::function<void(const MapPtr&)> onMap = {};           ///< the map has grown or moved, for the map view
    std::function<void(const LiveMapPtr&)> onScans = {};     ///< then also: all its scans, how far they count
};

/// What a station's map starts with.
struct StationMappingSetup {
    std::vector<RobotDescription> robots;
    std::string station;  ///< persistent identity
    LiveSettings settings;
    std::vector<KeyScanSample> earlier;           ///< key scans of the mission's earlier sessions ...
    std::vector<ScanLinksSample> earlierLinks{};  ///< ... and what they were registered against
    std::filesystem::path mission{};              ///< its folder, which keeps the robots' files
};

/// The map of a station on live robots, and the operator's decisions on its scans. Their results are in the
/// mission's log, and the map follows what the log takes back. Only the station that holds the map's grant
/// registers and decides. Scans that come while nobody holds it wait, the newest ten seconds of them. Any
/// thread; no call waits for the mapping, so later errors are reported as messages.
class StationMapping : public EventSink {
public:
    /// @p mission must outlive close(). @p mayMap: whether the station holds the map's grant.
    StationMapping(LiveMission& mission, std::function<bool()> mayMap, StationMappingSetup setup,
                   StationMappingListener listener);
    ~StationMapping() override;

    void close() override;  ///< as of LiveMapping
    /// Calls @p done on the mapping's thread, once all waiting work is done and no poses are being solved.
    /// Does not call it if the mapping ends before. Work that waits for the log is not waited for.
    void whenCalm(std::function<void()> done);
    void onEvent(const Event& event) override;  ///< all events of the mission, in order, from its thread

    /// Decisions on key scans (docs/live-mapping.md). Errors, in words: another station has the map, the map
    /// has no such scan, there is nothing to decide.
    Result<void> accept(std::uint64_t scan);
    Result<void> reject(std::uint64_t scan);
    Result<void> retry(std::uint64_t scan, const RetrySettings& settings = {});
    Result<void> rewind(Time moment);  ///< station's clock
    Result<void> undo();               ///< our newest decision, or area, that is not undone
    Result<void> redo();               ///< what was undone last
    /// Publishes that something of ours is taken back that is no decision on the map: the log of the map
    /// counts it.
    Result<void> takeBack(const UndoSample& undo);
    /// Proposes that the key scan @p scan was taken at about @p scanInMap, by what an older part of the map
    /// has there. If it fits, openLoop() asks whether it is that place. Otherwise the listener is notified.
    Result<void> propose(std::uint64_t scan, const Pose& scanInMap);
    /// Moves the submapOf() @p scan as the operator dragged it, so that this scan was taken at @p scanInMap.
    /// Links its scans with what they lie on there, and the map follows. undo() takes that back. Calls
    /// @p done on the mapping's thread with the number of links made, or why there are none. Errors, in
    /// words: another station has the map, the map has no such scan.
    Result<void> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                        std::function<void(Result<std::size_t>)> done);
    /// Answers @p asked, which is openLoop() of the mission. Either the two are one place, and the map is
    /// brought together there, or they are not, and it is not asked about again. undo() takes the answer
    /// back. Errors, in words: something else is asked by now, or nothing.
    Result<void> answerLoop(const OpenLoop& asked, bool same);
    /// Returns what the map would become if @p asked were one place. Starts to compute it on another thread:
    /// null until the first result, then the newest one while the map goes on. For the newest question only.
    [[nodiscard]] LoopPreviewPtr preview(const OpenLoop& asked);
    /// Takes back the newest loop that closed in the map, whoever closed it. Scans return to where the other
    /// links want them, and the loop does not close there again by itself.
    Result<void> undoLoop();
    [[nodiscard]] std::optional<MapDecision> loop() const;  ///< the one that undoLoop() would take back
    [[nodiscard]] ClosedLoops closedLoops() const;
    /// What undo() and redo() would take back or do again, by the log as it is now; empty: nothing.
    [[nodiscard]] std::optional<MapDecision> undoable() const;
    [[nodiscard]] std::optional<MapDecision> redoable() const;

    /// Whether the station makes the map, and decides on it.
    [[nodiscard]] bool makesMap() const;

    /// Sets what of the world enters the map, from the next scan on. It is logged, undone like decisions, and
    /// kept when the station restarts. Error when another station has the map.
    Result<void> setCrop(const MapCrop& crop);
    [[nodiscard]] MapCrop crop() const;

    /// Puts @p robot to where the operator places it (base_link), roughly: its laser, or its next 3D scan, is
    /// looked for about there. Without that it is placed by itself beside the robot that makes the map. The
    /// result shows in robots() and is reported as a message.
    Result<void> place(const std::string& robot, const Pose& baseInMap);
    /// Looks for a robot in the whole map by its newest 3D scan, and puts it to where it is found. Its next
    /// scan shows whether it stands there. The listener is notified of the result.
    Result<void> lookFor(const std::string& robot);

    /// A question about a scanner that the map finds in error; empty: none, or the operator has answered.
    [[nodiscard]] std::optional<ScannerQuestion> scannerQuestion() const;
    /// Answers it: the scanner is corrected from its next scan on and in the robot's file, or is left as it
    /// is and not asked about again. The result is reported as a message. Errors: another station has the
    /// map, something else is asked by now.
    Result<void> answerScanner(const ScannerQuestion& asked, bool correct);

    [[nodiscard]] LiveMapPtr scans() const;       ///< never null
    [[nodiscard]] RobotsInMapPtr robots() const;  ///< where they are now; never null

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
