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

/// Registers scans of robots into one level map while they drive. Each scan is registered against the key
/// scans near it. A scan that does not fit enters as uncertain, at its pose by odometry. Nothing is built on
/// it until the operator decides.
///
/// Results and decisions are samples for the log, from which restore() and follow() make the same map again.
/// An undo is an UndoSample in the log; afterwards follow() updates the mapper. It has no clock and no
/// thread: the caller passes the time of the station's clock. One thread at a time.
class LiveMapper {
public:
    /// @p station: persistent identity of this station, written into the samples.
    LiveMapper(std::string station, LiveSettings settings);
    ~LiveMapper();
    LiveMapper(LiveMapper&&) noexcept;
    LiveMapper& operator=(LiveMapper&&) noexcept;

    /// Sets the body of @p robot. Points on it are removed from the robot's scans.
    void setBody(const std::string& robot, RobotBody body);
    /// Sets the area of the map, also for the scans that are already in it. Points of these scans come back
    /// if an earlier area excluded them and this one does not. Points that were left out before a scan
    /// entered do not come back.
    void setCrop(MapCrop crop);
    /// Removes points on @p bodies from the key scan @p id. These are other robots that are now known to have
    /// been there while the scan was taken. They replace the bodies of the last call. Returns false, and
    /// changes nothing, if the bodies are the same, or if no points of the scan are on old or new bodies.
    bool leaveOut(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// Returns the bodies of the last leaveOut() for the key scan @p id; empty: no bodies.
    [[nodiscard]] std::vector<BodyInScan> bodiesIn(std::uint64_t id) const;
    /// Sets roughly where @p robot is when its next scan is taken. Used for a second robot, or for one that
    /// was carried.
    void place(const std::string& robot, const Pose& baseInMap);
    /// Lets @p robot, whose pose is unknown, begin a new part of the map with its next sufficiently complete
    /// scan. If the robot is in the map, the part begins with its next scan that does not fit. If place() is
    /// called first, no part begins. The part lies aside until a place is found that both it and another part
    /// have seen. Then the operator is asked, and links join the two.
    void beginPart(const std::string& robot);
    /// Returns whether nothing can be built on @p robot's scans: they no longer fit, and the pose by odometry
    /// may be too wrong (FitSettings::mostDeviation). Without odometry it always may.
    [[nodiscard]] bool isAstray(const std::string& robot) const;

    /// Registers @p scan. The first sufficiently complete scan defines the map's frame: level, with the
    /// scan's position and heading. Scans of another robot do not enter before place() or beginPart().
    /// @p others: where other robots were in the map while @p scan was taken; points on them are left out.
    [[nodiscard]] MapUpdate add(const LiveScan& scan, Time now, std::span<const PlacedBody> others = {});

    /// The operator's decisions about the key scan @p id. Each returns the new poses and trust, for the log.
    /// Error: the map has no scan with that id.
    [[nodiscard]] Result<ScanPosesSample> accept(std::uint64_t id, Time now);
    [[nodiscard]] Result<ScanPosesSample> reject(std::uint64_t id, Time now);
    /// Registers the key scan @p id again. It becomes certain if it fits now. Otherwise it is uncertain and
    /// stays where it is.
    [[nodiscard]] Result<ScanPosesSample> retry(std::uint64_t id, const RetrySettings& settings, Time now);
    /// Sets aside all scans that entered after @p moment (station's clock). Robots continue from the
    /// remaining scans. Error: no scan entered after it.
    [[nodiscard]] Result<ScanPosesSample> rewind(Time moment, Time now);

    /// Restores a key scan from the log when the station starts again. The robot's odometry may have been
    /// reset since then. A scan that is already in the map is not changed.
    void restore(const KeyScanSample& keyScan);
    /// Takes a key scan that another station registers now; it replaces a scan with the same id. Later scans
    /// of this station get ids from the next thousand on, since the other station may use further ids that
    /// are not received here.
    void adopt(const KeyScanSample& keyScan);
    /// Gives later scans ids from the next thousand on, and links ids from the next block. Call when another
    /// station has worked on the map.
    void beginBlock();
    /// Sets the poses and trust of all key scans of the mission, after an undo or from another station. Scans
    /// that are not in @p poses are set aside.
    void follow(std::span<const ScanPose> poses);

    /// Restores links from the log, or takes those of another station.
    void restore(const ScanLinksSample& links);
    /// Sets loop links to their present state: those that were removed are not active.
    void followLoops(std::span<const Link> loops);

    /// Treats the restored map as solved: problem() is empty until something changes.
    void takeAsSolved();

    /// Returns the links that the last decision changed. They belong into the log before the poses of that
    /// decision. Returned only once. Empty: none.
    [[nodiscard]] std::optional<ScanLinksSample> takeLinks();

    /// Returns the newest scan that shall be looked for in the earlier part of the map. The caller runs
    /// recognise() on any thread, and recognised() if that finds the scan. Returned only once. Empty: none.
    [[nodiscard]] std::optional<SoughtPlace> sought();
    /// Takes the result of recognise(): the scan @p sought was taken at @p scanInMap. When enough such places
    /// agree, returns their links for the log. They are a question for the operator, as in MapUpdate::loop.
    /// Empty: not yet, or the map has moved since.
    [[nodiscard]] std::optional<ScanLinksSample> recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                            Time now);

    /// Proposes a loop that the operator shows: the key scan @p id was taken at about @p scanInMap, near an
    /// older part of the map. Returns its link for the log, as a question like MapUpdate::loop. The error
    /// says why not, for example because the scan does not fit there.
    [[nodiscard]] Result<ScanLinksSample> propose(std::uint64_t id, const Pose& scanInMap, Time now);

    /// Returns whether scans wait for meetMore(). After two parts of the map were joined, scans of one part
    /// may see what the other part saw.
    [[nodiscard]] bool meetsMore() const;
    /// Checks one of the waiting scans. After the last one, returns all links that agree, for the log, as in
    /// MapUpdate::loop. Empty: more scans wait, or no links agree.
    [[nodiscard]] std::optional<ScanLinksSample> meetMore(Time now);
    /// Forgets the scans that wait for meetMore(), because another station now makes the map.
    void meetNoMore();

    /// Moves the submapOf() @p scan as a whole, so that @p scan lies at @p scanInMap. The operator asked for
    /// it. Returns links between the moved scans and other scans there, for the log, as far as they fit and
    /// agree. Poses change only later, by problem(). Error: too few links agree.
    [[nodiscard]] Result<ScanLinksSample> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                                 Time now);

    /// Joins two parts of the map. @p scansInMap: about where scans of one part lie on the other part, in the
    /// map, by scan id. Returns links of the scans that fit there, for the log. Poses change only later, by
    /// problem(). Empty: fewer than LoopSettings::partsAgree fit.
    [[nodiscard]] std::optional<ScanLinksSample> join(const std::map<std::uint64_t, Pose>& scansInMap,
                                                      Time now);

    /// Returns the map that has to be solved, once after a loop was closed or removed. The caller runs
    /// solve() on any thread, then settle(). Empty: there is nothing to solve, or it is being solved.
    [[nodiscard]] std::optional<MapProblem> problem();
    /// Returns the problem that the map would be if it had @p links, for previewOf(). Its solution must not
    /// be passed to settle().
    [[nodiscard]] MapProblem problemWith(std::span<const Link> links) const;
    /// Moves the scans to @p solution. Scans that entered since then move with the scans they were registered
    /// against. If a decision was made since then, nothing moves, and problem() returns the map once more.
    [[nodiscard]] Settled settle(const MapSolution& solution, Time now);
    /// Returns what the map shows so far about the scanner of @p robot.
    [[nodiscard]] ScannerCalibration calibration(const std::string& robot) const;
    /// Restarts calibration(), because the scanner of @p robot is corrected differently from its next scan
    /// on.
    void recalibrate(const std::string& robot);
    /// Call this instead of settle() if another station now makes the map. problem() then returns the map
    /// once more.
    void leaveUnsettled();

    /// Returns the ids of key scans whose poses relative to the key scan @p id are nearly certain, @p id
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
