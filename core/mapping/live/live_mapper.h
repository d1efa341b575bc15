#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/event/map_samples.h"
#include "core/event/scan_bodies.h"
#include "core/event/scan_links.h"
#include "core/mapping/calibration/scanner_calibration.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/live/loops/places/sought_place.h"
#include "core/mapping/live/loops/submap.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/map/map_update.h"

namespace leitstand {

/// Registers scans of robots, while they drive, into one map that is level. Each scan is registered against
/// the key scans near it. A scan that does not fit enters as uncertain, at its pose by odometry. Nothing is
/// built on it until the operator decides. Results and decisions are samples for the log; restore() and
/// follow() make the same map of them again. An undo is an UndoSample in the log, after which follow()
/// updates the mapper. Without clock and thread: the caller passes the time of the station's clock. One
/// thread at a time.
class LiveMapper {
public:
    /// @p station: persistent identity of this station, for the samples.
    LiveMapper(std::string station, LiveSettings settings);
    ~LiveMapper();
    LiveMapper(LiveMapper&&) noexcept;
    LiveMapper& operator=(LiveMapper&&) noexcept;

    /// Sets the body of @p robot, which is removed from its scans.
    void setBody(const std::string& robot, RobotBody body);
    /// Sets the area of the map, also for the scans that are in it. A wider area brings back points that an
    /// earlier one left out of these, but not points left out before a scan entered.
    void setCrop(MapCrop crop);
    /// Leaves points on @p bodies out of the key scan @p id: where other robots are now known to have been
    /// while it was taken. Replaces the bodies of the call before. Returns false, and keeps nothing, if the
    /// bodies are the same as before, or if neither these nor those before have points of the scan.
    bool leaveOut(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// Returns the bodies of the last leaveOut() for the key scan @p id; empty: none.
    [[nodiscard]] std::vector<BodyInScan> bodiesIn(std::uint64_t id) const;
    /// Sets roughly where @p robot is when its next scan is taken: for a second robot, or one that was
    /// carried.
    void place(const std::string& robot, const Pose& baseInMap);
    /// Lets @p robot, whose pose is unknown, begin a part of the map with its next scan that is whole enough.
    /// If the robot is in the map, the part begins with its next scan that does not fit. If it is placed
    /// before, no part begins. The part lies aside until a place is found that both it and another part have
    /// seen. Then the operator is asked, and links join the two.
    void beginPart(const std::string& robot);
    /// Returns whether @p robot's scans do not fit any more, and it may be too far from its pose by odometry
    /// for anything to be built on it (FitSettings::mostDeviation). Without odometry it always may.
    [[nodiscard]] bool isAstray(const std::string& robot) const;

    /// Registers @p scan. The first scan that is whole enough defines the map's frame: level, with the scan's
    /// position and heading. Scans of another robot do not enter before place() or beginPart(). @p others:
    /// where other robots were in the map while @p scan was taken; points on them are left out.
    [[nodiscard]] MapUpdate add(const LiveScan& scan, Time now, std::span<const PlacedBody> others = {});

    /// The operator's decisions on the key scan @p id. Each returns the new poses and trust for the log.
    /// Error: the map has no scan of that id.
    [[nodiscard]] Result<ScanPosesSample> accept(std::uint64_t id, Time now);
    [[nodiscard]] Result<ScanPosesSample> reject(std::uint64_t id, Time now);
    /// Registers the key scan @p id again. It becomes certain if it fits now. Otherwise it is uncertain and
    /// stays where it is.
    [[nodiscard]] Result<ScanPosesSample> retry(std::uint64_t id, const RetrySettings& settings, Time now);
    /// Sets aside all scans that entered after @p moment (station's clock). Robots continue from the scans
    /// that are left. Error: no scan entered after it.
    [[nodiscard]] Result<ScanPosesSample> rewind(Time moment, Time now);

    /// Restores a key scan of the log, when the station starts again. The robot's odometry may have restarted
    /// since. A scan that the map has already is left as it is.
    void restore(const KeyScanSample& keyScan);
    /// The same for a key scan that another station registers now; it replaces another scan of the same id.
    /// Later scans of this station get ids from the next thousand on. The other station may continue its own
    /// ids without being heard here.
    void adopt(const KeyScanSample& keyScan);
    /// Gives later scans ids from the next thousand on, and links ids from the next block: another station
    /// took part in the map.
    void beginBlock();
    /// Takes over the poses and the trust of all key scans of the mission, after an undo or from another
    /// station. Scans that are not in @p poses are set aside.
    void follow(std::span<const ScanPose> poses);

    /// Restores links of the log, or of another station.
    void restore(const ScanLinksSample& links);
    /// Sets links of loops to their present state: those that were taken back are not active.
    void followLoops(std::span<const Link> loops);

    /// Treats the restored map as solved: problem() is empty until something changes.
    void takeAsSolved();

    /// Returns the links that the newest decision changed, only once: for the log, before the poses of that
    /// decision. Empty: none.
    [[nodiscard]] std::optional<ScanLinksSample> takeLinks();

    /// Returns the newest scan that is to be looked for in the earlier part of the map, only once. The caller
    /// runs recognise() on any thread, and recognised() if that finds the scan. Empty: none.
    [[nodiscard]] std::optional<SoughtPlace> sought();
    /// Takes the result of recognise(): the @p sought scan was taken at @p scanInMap. Once enough such places
    /// agree, returns their links for the log. They are a question, as in MapUpdate::loop. Empty: not yet, or
    /// the map moved meanwhile.
    [[nodiscard]] std::optional<ScanLinksSample> recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                            Time now);

    /// Proposes a loop that the operator shows: the key scan @p id was taken at about @p scanInMap, near an
    /// older part of the map. Returns its link for the log, a question as in MapUpdate::loop. Errors, in
    /// words, for example that the scan does not fit there.
    [[nodiscard]] Result<ScanLinksSample> propose(std::uint64_t id, const Pose& scanInMap, Time now);

    /// Returns whether scans are left for meetMore(). After two parts of the map came together, scans of one
    /// part may see what the other part saw.
    [[nodiscard]] bool meetsMore() const;
    /// Checks one of the scans that are left. After the last one, returns the links of all that agree, for
    /// the log, as in MapUpdate::loop. Empty: scans are left, or none agree.
    [[nodiscard]] std::optional<ScanLinksSample> meetMore(Time now);
    void meetNoMore();  ///< drops the scans that are left for meetMore(): another station makes the map now

    /// Moves the submapOf() @p scan as a whole for the operator, so that @p scan lies at @p scanInMap.
    /// Returns links between its scans and the other scans there, for the log, as far as they fit and agree.
    /// Poses change only later, by problem(). Error, in words: too few links agree.
    [[nodiscard]] Result<ScanLinksSample> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                                 Time now);

    /// Joins two parts of the map. @p scansInMap: about where scans of one part, by id, lie on the other
    /// part, in the map. Returns links of the scans that fit there, for the log. Poses change only later, by
    /// problem(). Empty: fewer than LoopSettings::partsAgree fit.
    [[nodiscard]] std::optional<ScanLinksSample> join(const std::map<std::uint64_t, Pose>& scansInMap,
                                                      Time now);

    /// Returns the map to be solved, once after a loop closed or was taken back. The caller runs solve() on
    /// any thread, then settle(). Empty: there is nothing to solve, or it is being solved.
    [[nodiscard]] std::optional<MapProblem> problem();
    /// The same as if the map had @p links, for previewOf(). Its solution is not for settle().
    [[nodiscard]] MapProblem problemWith(std::span<const Link> links) const;
    /// Moves the scans to @p solution. Scans that entered meanwhile move with those they were registered
    /// against. If a decision came meanwhile, nothing changes, and problem() returns the map once more.
    [[nodiscard]] Settled settle(const MapSolution& solution, Time now);
    /// Returns what the map shows of @p robot's scanner so far, if it has one.
    [[nodiscard]] ScannerCalibration calibration(const std::string& robot) const;
    /// Restarts calibration(): @p robot's scanner is corrected differently from its next scan on.
    void recalibrate(const std::string& robot);
    /// Called instead of settle() if another station makes the map now: problem() returns the map once more.
    void leaveUnsettled();

    /// Returns ids of key scans whose poses relative to the key scan @p id are nearly certain, itself
    /// included.
    [[nodiscard]] std::set<std::uint64_t> together(std::uint64_t id) const;
    /// Returns where @p robot was at its newest scan; empty: unknown.
    [[nodiscard]] std::optional<RobotFix> fix(const std::string& robot) const;
    /// Returns a snapshot of the map.
    [[nodiscard]] LiveMapPtr map() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
