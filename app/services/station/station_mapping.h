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

/// Functions that are called on threads of the station and must not block them; any may be empty.
struct StationMappingListener {
    std::function<void(const std::string&)> onMessage = {};  ///< for the operator, in words
    std::function<void(const MapPtr&)> onMap = {};           ///< the map has grown or moved, for the map view
    std::function<void(const LiveMapPtr&)> onScans =
        {};  ///< also then: all key scans, and whether they count
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

/// The map of a station on live robots, and the operator's decisions on its scans. Results and decisions are
/// in the mission's log, and the map follows when the log takes them back. Only the station that holds the
/// map's grant registers and decides. While this station does not hold it, scans wait, the newest ten seconds
/// of them. Any thread; no call waits for the mapping, so later errors are reported as messages.
class StationMapping : public EventSink {
public:
    /// @p mission must outlive close(). @p mayMap: whether the station holds the map's grant.
    StationMapping(LiveMission& mission, std::function<bool()> mayMap, StationMappingSetup setup,
                   StationMappingListener listener);
    ~StationMapping() override;

    void close() override;  ///< as of LiveMapping
    /// Calls @p done on the mapping's thread, once all waiting work is done and no poses are being solved.
    /// Does not call it if the mapping ends before. Does not wait for work that itself waits for the log.
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
    /// Publishes @p undo, which takes back something of ours that is no decision on the map, such as a find.
    /// Every undo of this station has to be published here, since the log of the map counts them.
    Result<void> takeBack(const UndoSample& undo);
    /// Proposes that the key scan @p scan was taken at about @p scanInMap. Compares it with what an older
    /// part of the map has there. If the two fit, openLoop() asks whether they are the same place. Otherwise
    /// the listener is notified.
    Result<void> propose(std::uint64_t scan, const Pose& scanInMap);
    /// Moves the submapOf() @p scan as the operator dragged it, so that this scan was taken at @p scanInMap.
    /// Links its scans with what they lie on there, and the map follows. undo() takes that back. Calls
    /// @p done on the mapping's thread with the number of links made, or why there are none. Errors, in
    /// words: another station has the map, the map has no such scan.
    Result<void> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                        std::function<void(Result<std::size_t>)> done);
    /// Answers @p asked, which is openLoop() of the mission. @p same: the two are one place, and the map is
    /// brought together there. Otherwise they are not, and are not asked about again. undo() takes the answer
    /// back. Errors, in words: another station has the map, something else is asked by now, or nothing.
    Result<void> answerLoop(const OpenLoop& asked, bool same);
    /// Returns what the map would become if @p asked were answered with the same place. Computes it on
    /// another thread: null until the first result, then the newest result while the map goes on. Keeps
    /// results of the newest question only.
    [[nodiscard]] LoopPreviewPtr preview(const OpenLoop& asked);
    /// Takes back the newest loop that closed in the map, whoever closed it. Scans return to the poses that
    /// the other links give them, and the loop does not close there again by itself.
    Result<void> undoLoop();
    [[nodiscard]] std::optional<MapDecision> loop() const;  ///< the one that undoLoop() would take back
    [[nodiscard]] ClosedLoops closedLoops() const;
    /// What undo() and redo() would take back or do again, by the log as it is now; empty: nothing.
    [[nodiscard]] std::optional<MapDecision> undoable() const;
    [[nodiscard]] std::optional<MapDecision> redoable() const;

    /// Whether the station makes the map, and decides on it.
    [[nodiscard]] bool makesMap() const;

    /// Sets which part of the world belongs into the map, also of scans that are in it already. It is logged,
    /// undone like decisions, and kept when the station restarts. Error when another station has the map.
    Result<void> setCrop(const MapCrop& crop);
    [[nodiscard]] MapCrop crop() const;

    /// Places @p robot (base_link) roughly at @p baseInMap, where the operator puts it: what its laser or its
    /// next 3D scan sees is looked for around there. A robot that surely is in another part of the map is not
    /// moved: its newest key scan is proposed there, as by propose(). Without this call, a robot is placed by
    /// itself beside the robot that makes the map. The result shows in robots() and is reported as a message.
    Result<void> place(const std::string& robot, const Pose& baseInMap);
    /// Looks for @p robot in the map by its newest 3D scan, and places it where it is found
    /// (LostRobots::lookFor()). Its next scan shows whether it stands there. The listener is notified of the
    /// result.
    Result<void> lookFor(const std::string& robot);

    /// Makes the map with the scanner of @p robot whose clouds are on @p topic, from its next cloud on.
    /// Errors, in words: another station has the map, the robot has no such clouds.
    Result<void> mapWith(const std::string& robot, const std::string& topic);
    /// Returns the topic whose clouds make the map of @p robot, which has several scanners; empty: they are
    /// still compared.
    [[nodiscard]] std::string mapsWith(const std::string& robot) const;

    /// Returns a question about a scanner that the map finds in error. Empty: none, the operator has
    /// answered, or another station has the map.
    [[nodiscard]] std::optional<ScannerQuestion> scannerQuestion() const;
    /// Answers @p asked. @p correct: the scanner is corrected from its next scan on and in the robot's file.
    /// Otherwise it is left as it is and not asked about again. The result is reported as a message. Errors:
    /// another station has the map, or something else is asked by now.
    Result<void> answerScanner(const ScannerQuestion& asked, bool correct);

    [[nodiscard]] LiveMapPtr scans() const;       ///< never null
    [[nodiscard]] RobotsInMapPtr robots() const;  ///< where they are now; never null

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
