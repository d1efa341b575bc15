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
#include "core/mapping/live/loops/sought_place.h"
#include "core/mapping/live/loops/submap.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/mapping/live/map/map_update.h"

namespace leitstand {

/// Registers scans of robots while they drive into one level map, each against the key scans near it. A scan
/// that does not fit enters as uncertain, at its pose by odometry. Nothing is built on it until the operator
/// decides. Results and decisions are samples for the log, from which the same map is made again (restore(),
/// follow()). Taking one back is an UndoSample there, after which follow() updates the mapper. Without clock
/// and thread: the caller passes the time of the station's clock. One thread at a time.
class LiveMapper {
public:
    /// @p station: persistent identity, for the samples.
    LiveMapper(std::string station, LiveSettings settings);
    ~LiveMapper();
    LiveMapper(LiveMapper&&) noexcept;
    LiveMapper& operator=(LiveMapper&&) noexcept;

    /// Sets the body that is removed from a robot's scans.
    void setBody(const std::string& robot, RobotBody body);
    /// Sets the area of all scans, also of those in the map. A wider area brings back what an earlier one
    /// left out of them, but not what never came in.
    void setCrop(MapCrop crop);
    /// Leaves other robots out of the key scan @p id, at @p bodies, where they are now known to have been
    /// while it was taken. This replaces what was left out for other robots before. Returns whether it has,
    /// or had, points of them; else nothing is kept.
    bool leaveOut(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// Returns the other robots that are left out of the key scan @p id since it entered.
    [[nodiscard]] std::vector<BodyInScan> bodiesIn(std::uint64_t id) const;
    /// Places @p robot, roughly, for its next scan: for a second robot, or one that was carried.
    void place(const std::string& robot, const Pose& baseInMap);
    /// Lets @p robot, whose pose is unknown, begin a part of the map with its next scan that is whole enough,
    /// unless it is in the map or placed before. That part lies aside until a place is found that it and
    /// another one have seen. Then a question follows, and links. A robot that is in the map begins the part
    /// with its next scan that does not fit.
    void beginPart(const std::string& robot);
    /// Returns whether @p robot, whose scans do not fit any more, may be too far from its pose by odometry
    /// for anything to be built on it (FitSettings::mostDeviation). Also true without odometry.
    [[nodiscard]] bool isAstray(const std::string& robot) const;

    /// Registers @p scan. The first one that is whole enough defines the map: level, with its position and
    /// heading. Scans of another robot do not enter before it is placed, or begins a part. Leaves out @p
    /// others: other robots, wherever they were in the map while it was taken.
    [[nodiscard]] MapUpdate add(const LiveScan& scan, Time now, std::span<const PlacedBody> others = {});

    /// The operator's decisions on the key scan @p id. Error when the map does not have it, with its id.
    [[nodiscard]] Result<ScanPosesSample> accept(std::uint64_t id, Time now);
    [[nodiscard]] Result<ScanPosesSample> reject(std::uint64_t id, Time now);
    /// Registers a scan again. It becomes certain if it fits now, and stays where it is otherwise.
    [[nodiscard]] Result<ScanPosesSample> retry(std::uint64_t id, const RetrySettings& settings, Time now);
    /// Sets aside all scans that entered after @p moment (station's clock); robots continue from what is
    /// left.
    [[nodiscard]] Result<ScanPosesSample> rewind(Time moment, Time now);

    /// Restores a key scan of the log, when the station starts again. Its odometry may have restarted since.
    /// A scan that the map has already is left as it is.
    void restore(const KeyScanSample& keyScan);
    /// The same for a key scan that another station registers now; it replaces another one of its number.
    /// Later scans of this station get numbers from the next thousand on: the other station may continue its
    /// own numbers, unheard.
    void adopt(const KeyScanSample& keyScan);
    /// Begins the numbers of later scans with the next thousand: another station took part in the map.
    void beginBlock();
    /// Takes the poses and the trust of the mission's key scans, after an undo or from another station: of
    /// all of them. Scans that are missing are set aside.
    void follow(std::span<const ScanPose> poses);

    /// Restores links of the log, or of another station.
    void restore(const ScanLinksSample& links);
    /// Sets links of loops as they are now: what was taken back is not active.
    void followLoops(std::span<const Link> loops);

    /// Takes what was restored as solved: nothing is solved before something changes.
    void takeAsSolved();

    /// Returns the links that the newest decision made, once: for the log, before its poses. Empty: none.
    [[nodiscard]] std::optional<ScanLinksSample> takeLinks();

    /// Returns the newest scan to be looked for in the map's earlier part, by recognise() on any thread. If
    /// that finds it, recognised() follows. Empty: none.
    [[nodiscard]] std::optional<SoughtPlace> sought();
    /// Reports that the @p sought scan was taken at @p scanInMap. Returns links of a loop once enough of them
    /// agree, for the log, as MapUpdate::loop: a question. Empty: not yet, or the map moved meanwhile.
    [[nodiscard]] std::optional<ScanLinksSample> recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                            Time now);

    /// Proposes a loop that the operator shows: the key scan @p id was taken at about @p scanInMap, by an
    /// older part of the map. Returns a question for the log, as MapUpdate::loop. Errors, in words, also when
    /// it does not fit.
    [[nodiscard]] Result<ScanLinksSample> propose(std::uint64_t id, const Pose& scanInMap, Time now);

    /// Returns whether scans are left for meetMore(), since two parts of the map came together: they may see
    /// what the other part saw.
    [[nodiscard]] bool meetsMore() const;
    /// Checks one of these. After the last one, returns links of those that agree, for the log, as
    /// MapUpdate::loop.
    [[nodiscard]] std::optional<ScanLinksSample> meetMore(Time now);
    void meetNoMore();  ///< the map is another station's now

    /// Moves the submapOf() @p scan for the operator, so that this scan was taken at @p scanInMap. Returns,
    /// for the log, links of its scans to all others that they fit there, as far as they agree. Poses follow
    /// by problem(). Errors, in words: too few agree.
    [[nodiscard]] Result<ScanLinksSample> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                                 Time now);

    /// Joins two parts of the map: scans of one were taken at about @p scansInMap in the other. Returns their
    /// links, for the log, if at least LoopSettings::partsAgree fit there. Poses follow by problem(). Empty:
    /// fewer fit.
    [[nodiscard]] std::optional<ScanLinksSample> join(const std::map<std::uint64_t, Pose>& scansInMap,
                                                      Time now);

    /// Returns what is to be solved since a loop closed or was taken back: by solve() on any thread, then
    /// settle() follows. Empty: nothing, or it is being solved.
    [[nodiscard]] std::optional<MapProblem> problem();
    /// The same as if @p links were in the map: for previewOf(); nothing is settled with it.
    [[nodiscard]] MapProblem problemWith(std::span<const Link> links) const;
    /// Moves the scans to @p solution. Scans that entered meanwhile move with those they were registered
    /// against. If decisions came in between, it changes nothing, and problem() starts again.
    [[nodiscard]] Settled settle(const MapSolution& solution, Time now);
    /// Returns what the map shows of @p robot's scanner so far, if it has one.
    [[nodiscard]] ScannerCalibration calibration(const std::string& robot) const;
    /// Restarts calibration(): @p robot's scanner is corrected differently from its next scan on.
    void recalibrate(const std::string& robot);
    /// Called instead of settle() if the map is another station's now: problem() starts again.
    void leaveUnsettled();

    /// Returns ids of key scans whose poses relative to the key scan @p id are nearly certain, itself
    /// included.
    [[nodiscard]] std::set<std::uint64_t> together(std::uint64_t id) const;
    /// Returns where @p robot was; empty: unknown.
    [[nodiscard]] std::optional<RobotFix> fix(const std::string& robot) const;
    /// Returns a snapshot.
    [[nodiscard]] LiveMapPtr map() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
