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
#include "core/event/event.h"
#include "core/mapping/live/live_mapper.h"
#include "core/mapping/live/loops/loop_preview.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/map.h"
#include "core/mission/loops/open_loops.h"
#include "core/mission/state/undo.h"

namespace leitstand {

class LiveMission;

/// Called on threads of the station's, which they must not hold up; any may be empty.
struct StationMappingListener {
    std::function<void(const std::string&)> onMessage = {};  ///< for the operator, in words
    std::function<void(const MapPtr&)> onMap = {};  ///< the map has grown or moved, as the map view takes it
    std::function<void(const LiveMapPtr&)> onScans = {};  ///< likewise: all its scans, and how far they count
};

/// What a station's map begins with.
struct StationMappingSetup {
    std::vector<RobotDescription> robots;
    std::string station;  ///< persistent identity
    LiveSettings settings;
    std::vector<KeyScanSample> earlier;           ///< key scans of the mission's earlier sessions ...
    std::vector<ScanLinksSample> earlierLinks{};  ///< ... and what they were registered against
    std::filesystem::path mission{};              ///< its folder, which keeps the robots' files
};

/// The map of a station on live robots, and the operator's decisions on its scans. What comes of them is in
/// the mission's log, and the map follows what the log takes back. Only the station that holds the map's
/// grant registers and decides; scans that come while nobody has it wait, the newest ten seconds of them. Any
/// thread; nothing waits for the mapping: errors that show later are told as messages.
class StationMapping : public EventSink {
public:
    /// @p mission must outlive close(). @p mayMap: whether the station holds the map's grant.
    StationMapping(LiveMission& mission, std::function<bool()> mayMap, StationMappingSetup setup,
                   StationMappingListener listener);
    ~StationMapping() override;

    void close() override;  ///< as of LiveMapping
    /// @p done is called, on the mapping's thread, once all that waits is done and no poses are worked out
    /// any more; not where that ends before. What waits until the log has what was said is not waited for.
    void whenCalm(std::function<void()> done);
    void onEvent(const Event& event) override;  ///< all events of the mission, in order, from its thread

    /// Decisions on key scans (docs/live-mapping.md). Errors, in words: another station has the map, the map
    /// has no such scan, nothing to be decided.
    Result<void> accept(std::uint64_t scan);
    Result<void> reject(std::uint64_t scan);
    Result<void> retry(std::uint64_t scan, const RetrySettings& settings = {});
    Result<void> rewind(Time moment);  ///< station's clock
    Result<void> undo();               ///< the newest decision of ours, or area, that is not undone
    Result<void> redo();               ///< what was undone last
    /// Says that something of ours is taken back that is no decision on the map: the log of the map counts
    /// it.
    Result<void> takeBack(const UndoSample& undo);
    /// Shows that the key scan @p scan was taken at about @p scanInMap, by what an older part of the map has
    /// there: where it fits, openLoop() asks whether it does. The listener is told where it does not.
    Result<void> propose(std::uint64_t scan, const Pose& scanInMap);
    /// The operator has dragged the submapOf() @p scan, so that this one was taken at @p scanInMap: its scans
    /// are linked with what they lie on there, and the map follows. undo() takes that back. @p done is told
    /// how many links that made, or why none, on the mapping's thread. Errors, in words: another station has
    /// the map, the map has no such scan.
    Result<void> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                        std::function<void(Result<std::size_t>)> done);
    /// Answers @p asked, which is openLoop() of the mission: the two are one place, and the map is brought
    /// together there, or they are not, and it is not asked about again. undo() takes the answer back.
    /// Errors, in words: something else is asked by now, or nothing.
    Result<void> answerLoop(const OpenLoop& asked, bool same);
    /// What the map would become if @p asked were one place: null until it is worked out, beside, which this
    /// begins; the newest that is known while the map goes on. For the newest question only.
    [[nodiscard]] LoopPreviewPtr preview(const OpenLoop& asked);
    /// Takes back the newest loop that closed in the map, whoever closed it: scans go back to where the other
    /// links want them, and it does not close there again by itself.
    Result<void> undoLoop();
    [[nodiscard]] std::optional<MapDecision> loop() const;  ///< that undoLoop() would take back
    [[nodiscard]] ClosedLoops closedLoops() const;
    /// What undo() and redo() would take back or do again, as the log stands now; empty: nothing.
    [[nodiscard]] std::optional<MapDecision> undoable() const;
    [[nodiscard]] std::optional<MapDecision> redoable() const;

    /// Whether the station makes the map, and decides on it.
    [[nodiscard]] bool makesMap() const;

    /// What of the world enters the map, from the next scan on; in the log, undone as decisions are, and
    /// there again when the station restarts. Errors: another station has the map.
    Result<void> setCrop(const MapCrop& crop);
    [[nodiscard]] MapCrop crop() const;

    /// Puts @p robot to where the operator says it stands (base_link), roughly: its laser, or its next 3D
    /// scan, is looked for about there. Without that it is placed by itself beside the robot that makes the
    /// map. What came of it shows in robots() and is told as a message.
    Result<void> place(const std::string& robot, const Pose& baseInMap);
    /// Looks for a robot in the whole map by its newest 3D scan, and puts it to where it is found: its next
    /// scan tells whether it stands there. The listener is told what came of it.
    Result<void> lookFor(const std::string& robot);

    /// A scanner that the map finds to be off; empty: none, or the operator has answered.
    [[nodiscard]] std::optional<ScannerQuestion> scannerQuestion() const;
    /// Answers it: the scanner is corrected from its next scan on and in the robot's file, or is left as it
    /// is and not asked about again. What came of it is told as a message. Errors: another station has the
    /// map, something else is asked by now.
    Result<void> answerScanner(const ScannerQuestion& asked, bool correct);

    [[nodiscard]] LiveMapPtr scans() const;       ///< never null
    [[nodiscard]] RobotsInMapPtr robots() const;  ///< where they are now; never null

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
