#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/mapping/calibration/scanner_calibration.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/loops/map_problem.h"
#include "core/mapping/live/loops/sought_place.h"
#include "core/mapping/live/loops/submap.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/live_scan.h"
#include "core/registration/icp.h"

namespace leitstand {

/// Where a robot is in the map, as its newest scan tells.
struct Localisation {
    std::string robot;
    Time stamp{};                        ///< end of the scan, robot's clock
    Pose baseInMap = Pose::Identity();   ///< then
    Pose guessInMap = Pose::Identity();  ///< of base_link, by odometry alone since the scan before
    Pose odomInMap = Pose::Identity();   ///< where odometry's poses lie in the map from then on
    ScanTrust trust = ScanTrust::Certain;
    std::uint8_t doubts = 0;    ///< bits of ScanDoubt
    std::uint64_t keyScan = 0;  ///< the scan's id where it entered the map; 0: it only localised
    IcpResult icp;              ///< meaningless for the first scan
    double seconds = 0.0;       ///< of computing [s]
};

/// What came of a scan: what the log keeps, in this order, and where the robot is.
struct MapUpdate {
    std::optional<KeyScanSample> keyScan;
    std::optional<ScanLinksSample> links;  ///< what it was registered against
    std::optional<ScanPosesSample> poses;
    /// That closed with it: poses follow by LiveMapper::problem(). Links that are not active are a question
    /// to the operator.
    std::optional<ScanLinksSample> loop;
    Localisation localisation;
    ScanPtr ready;  ///< as it would enter: cleaned, labelled and thinned; null where it was not looked at ...
    Pose scanInMap = Pose::Identity();  ///< ... and where it was taken
};

/// Where a robot was at its newest scan, as the map is now: decisions move it too.
struct RobotFix {
    Time stamp{};                       ///< end of that scan, robot's clock
    Pose baseInMap = Pose::Identity();  ///< then
    double certainty = 0.0;             ///< 0 to 1: of what meets the map, and of its least certain direction
    std::uint8_t doubts = 0;            ///< bits of ScanDoubt
    double spinning = 0.0;              ///< SpinningWheels::way() [m]
    std::uint64_t part = 0;             ///< LiveKeyScan::part of what it is in

    /// The same at @p now, robot's clock: 0 where no scan came of late, which alone would tell.
    [[nodiscard]] double spinningAt(Time now) const {
        constexpr std::chrono::seconds Fresh(6);  // two turns of a slow scanner, and some
        return now - stamp < Fresh ? spinning : 0.0;
    }
};

/// What came of solving.
struct Settled {
    std::optional<ScanLinksSample> links;  ///< loops that the others speak against: poses do not follow them
    std::optional<ScanPosesSample> poses;  ///< of scans that moved noticeably
    double largest = 0.0;                  ///< shift of one [m]
};

/// How a scan is registered again.
struct RetrySettings {
    MatchSettings match;             ///< its wide schedule counts
    std::optional<Pose> guessInMap;  ///< of the scan; empty: where it is
};

/// Registers scans of robots while they drive into one map that is level: each against the key scans near it.
/// What does not fit enters as uncertain, stands where odometry says, and nothing is built on it until the
/// operator decides. Results and decisions are samples for the log, from which the same map comes about again
/// (restore(), follow()); taking one back is an UndoSample there, after which follow() tells the mapper.
/// Without clock and thread: the caller tells what time it is, on the station's clock. One thread at a time.
class LiveMapper {
public:
    /// @p station: persistent identity, for the samples.
    LiveMapper(std::string station, LiveSettings settings);
    ~LiveMapper();
    LiveMapper(LiveMapper&&) noexcept;
    LiveMapper& operator=(LiveMapper&&) noexcept;

    /// What a robot's scans are cleaned of.
    void setBody(const std::string& robot, RobotBody body);
    /// Of all scans, also those that are in the map: a wider area brings back what an earlier one left out of
    /// them, though not what never came in.
    void setCrop(MapCrop crop);
    /// It is known now that other robots were where @p bodies say while the key scan @p id was taken: what of
    /// it is on them is left out, in place of what was left out for other robots before. Whether it has, or
    /// had, points of them; else nothing is kept.
    bool leaveOut(std::uint64_t id, std::vector<BodyInScan> bodies);
    /// Other robots that are left out of the key scan @p id since it entered.
    [[nodiscard]] std::vector<BodyInScan> bodiesIn(std::uint64_t id) const;
    /// Where @p robot is when it sends its next scan, roughly: for a second robot, or one that was carried.
    void place(const std::string& robot, const Pose& baseInMap);
    /// The next scan of @p robot that is whole enough begins a part of the map of its own, unless the robot
    /// is in the map, or placed, by then: nobody knows where it is. That part lies aside until a place is
    /// found that it and another one have seen: then come a question, and links. One that is in the map
    /// begins it with its next scan that does not fit.
    void beginPart(const std::string& robot);
    /// Whether @p robot, whose scans do not fit any more, may be so far from where odometry has it that
    /// nothing of what it sees can be built on (FitSettings::mostDeviation), or no odometry tells.
    [[nodiscard]] bool isAstray(const std::string& robot) const;

    /// Registers @p scan. The first one that is whole enough defines the map: level, with its position and
    /// heading. Scans of another robot do not enter before it is placed, or begins a part. @p others: other
    /// robots, wherever they were in the map while it was taken; they are left out.
    [[nodiscard]] MapUpdate add(const LiveScan& scan, Time now, std::span<const PlacedBody> others = {});

    /// The operator's decisions on the key scan @p id; errors name it where the map does not have it.
    [[nodiscard]] Result<ScanPosesSample> accept(std::uint64_t id, Time now);
    [[nodiscard]] Result<ScanPosesSample> reject(std::uint64_t id, Time now);
    /// Registers a scan again; it becomes certain where it fits now, and stays where it is otherwise.
    [[nodiscard]] Result<ScanPosesSample> retry(std::uint64_t id, const RetrySettings& settings, Time now);
    /// Sets aside all scans that entered after @p moment (station's clock); robots go on from what is left.
    [[nodiscard]] Result<ScanPosesSample> rewind(Time moment, Time now);

    /// Takes back a key scan of the log, when the station starts again. Its odometry may have begun anew
    /// since. One that the map has already is left as it is.
    void restore(const KeyScanSample& keyScan);
    /// The same for a key scan that another station registers now, but that it counts instead of another one
    /// of its number. Scans that this station enters later get numbers from the next thousand on: the other
    /// may go on, unheard, with those that follow its own.
    void adopt(const KeyScanSample& keyScan);
    /// Numbers of scans that enter later begin with the next thousand: another station had a part in the map.
    void beginBlock();
    /// Takes over where the mission has its key scans and how far they count, after an undo or from another
    /// station: all of them; those that are missing are set aside.
    void follow(std::span<const ScanPose> poses);

    /// The same for links of the log, or of another station.
    void restore(const ScanLinksSample& links);
    /// Links of loops, as they are now: what was taken back is not active.
    void followLoops(std::span<const Link> loops);

    /// What was restored stands as the log has it: nothing is solved before something changes.
    void takeAsSolved();

    /// Links that the newest decision made, once: for the log, before its poses. Empty: none.
    [[nodiscard]] std::optional<ScanLinksSample> takeLinks();

    /// The newest scan that is to be looked for in the map's earlier part: by recognise(), on any thread;
    /// where that finds it, then comes recognised(). Empty: there is none.
    [[nodiscard]] std::optional<SoughtPlace> sought();
    /// It sees what was seen from @p scanInMap. Links of a loop once enough of them agree, for the log, as
    /// MapUpdate::loop: a question. Empty: not yet, or the map moved meanwhile.
    [[nodiscard]] std::optional<ScanLinksSample> recognised(const SoughtPlace& sought, const Pose& scanInMap,
                                                            Time now);

    /// The operator shows that the key scan @p id was taken at about @p scanInMap, by what an older part of
    /// the map has there: a question for the log, as MapUpdate::loop. Errors, in words, also where it does
    /// not fit.
    [[nodiscard]] Result<ScanLinksSample> propose(std::uint64_t id, const Pose& scanInMap, Time now);

    /// Since two parts of the map came together: whether scans are left that may see what the other part has
    /// seen, for meetMore().
    [[nodiscard]] bool meetsMore() const;
    /// Looks at one of these; after the last one links for the log, as MapUpdate::loop: of those that agree.
    [[nodiscard]] std::optional<ScanLinksSample> meetMore(Time now);
    void meetNoMore();  ///< the map is another station's now

    /// The operator has moved the submapOf() @p scan, so that this one was taken at @p scanInMap: links of
    /// its scans to all others that they fit there, as far as they agree, for the log; poses follow by
    /// problem(). Errors, in words: too few do.
    [[nodiscard]] Result<ScanLinksSample> moveTo(std::uint64_t scan, SubmapKind kind, const Pose& scanInMap,
                                                 Time now);

    /// It is known that scans of one part of the map were taken at about @p scansInMap in another one: their
    /// links where at least LoopSettings::partsAgree fit there, for the log; poses follow by problem().
    /// Empty: fewer do.
    [[nodiscard]] std::optional<ScanLinksSample> join(const std::map<std::uint64_t, Pose>& scansInMap,
                                                      Time now);

    /// What is to be solved since a loop closed or was taken back: by solve(), on any thread; then comes
    /// settle(). Empty: nothing, or somebody is at it.
    [[nodiscard]] std::optional<MapProblem> problem();
    /// The same if @p links were as they are there: for previewOf(), nothing is settled with it.
    [[nodiscard]] MapProblem problemWith(std::span<const Link> links) const;
    /// Puts the scans to where @p solution has them. What entered meanwhile goes along with what it was
    /// registered against. Where decisions came in between it changes nothing, and problem() begins anew.
    [[nodiscard]] Settled settle(const MapSolution& solution, Time now);
    /// What the map tells of @p robot's scanner so far, where it has one.
    [[nodiscard]] ScannerCalibration calibration(const std::string& robot) const;
    /// What @p robot's scanner says is corrected otherwise from its next scan on.
    void recalibrate(const std::string& robot);
    void leaveUnsettled();  ///< instead, where the map is another station's now: problem() begins anew

    /// Ids of key scans that are nearly certain to lie right to the key scan @p id, itself included.
    [[nodiscard]] std::set<std::uint64_t> together(std::uint64_t id) const;
    /// Empty: nobody knows.
    [[nodiscard]] std::optional<RobotFix> fix(const std::string& robot) const;
    /// A snapshot.
    [[nodiscard]] LiveMapPtr map() const;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
