#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/candidate_sample.h"
#include "core/event/find_sample.h"
#include "core/event/map_samples.h"
#include "core/event/scan_links.h"
#include "core/event/station_samples.h"
#include "core/mission/state/robot_state.h"
#include "core/mission/state/shared_value.h"

namespace leitstand {

/// A key scan as a decision, without its points, which stay in the log.
struct KeyScanEntry {
    std::uint64_t id = 0;
    std::string robot;
    Time stamp{};                          ///< station's clock
    Pose sensorInBase = Pose::Identity();  ///< at the end of the sweep
    Pose scanInMap = Pose::Identity();     ///< when it was added
    std::optional<Pose> sensorInOdom{};    ///< by odometry, at the end of the sweep
    std::uint64_t matched = 0;             ///< id of the scan it was registered against; 0: none
    std::uint64_t points = 0;
};

/// An event that undo can take back, and whether it is taken back. All of them are kept in order, also for a
/// timeline to jump to.
struct Decision {
    std::uint64_t sequence = 0;
    Time received{};      ///< station's clock
    bool undone = false;  ///< by an undo that is not undone itself
    /// A ScanLinksSample holds only those of its links that close loops.
    std::variant<FindSample, NoteSample, ScanPosesSample, KeyScanEntry, UndoSample, MapCropSample,
                 ScanLinksSample, ScanBodiesSample>
        content;
};

/// Identifies a victim or another find.
using FindKey = std::pair<FindSample::Kind, std::uint32_t>;  ///< kind, number

/// A victim as the newest decision that is not undone has it.
struct FindState {
    std::uint64_t sequence = 0;  ///< of that decision
    std::uint64_t filed = 0;     ///< sequence of the first that is not undone
    FindSample victim;
};

/// The first report of a candidate: its robot, and how that robot drove then. A find of it counts this way,
/// however late it is filed.
struct FirstReport {
    Time stamp{};                    ///< station's clock
    std::string robot;               ///< empty: unknown
    std::optional<bool> autonomous;  ///< it drove itself; empty: unknown
};

/// A candidate: what the station believes to have found, by its newest sample.
struct CandidateState {
    std::uint64_t sequence = 0;  ///< of the newest
    std::uint64_t first = 0;     ///< sequence of the first of this id
    FirstReport firstReport;     ///< by that event
    CandidateSample candidate;
};

/// A key scan and where it is now.
struct KeyScanState {
    std::uint64_t sequence = 0;  ///< of the event that has its points
    KeyScanEntry entry;
    ScanPose pose;                   ///< newest that is not undone
    std::uint64_t poseSequence = 0;  ///< of the event that set it; the scan's own when nothing moved it
};

/// A link that closes a loop, as the newest decision that is not undone has it.
struct LoopState {
    std::uint64_t sequence = 0;  ///< of that decision
    Link link;
};

/// A corner of the area that belongs to the map. It moves with the key scan that was nearest when it was
/// drawn.
struct AreaCorner {
    Eigen::Vector2d drawn = Eigen::Vector2d::Zero();  ///< in the map frame of that time [m]
    std::uint64_t scan = 0;                           ///< id of that scan; 0: there was none
    Pose scanInMap = Pose::Identity();                ///< at that time
};

/// The area that belongs to the map, as the newest decision that is not undone has it.
struct CropState {
    std::uint64_t sequence = 0;       ///< of that decision
    Time received{};                  ///< station's clock
    MapCropSample sample;             ///< as published: areaInMap() returns where it is now
    std::vector<AreaCorner> corners;  ///< of its polygon
};

/// Who holds a grant.
struct GrantState {
    std::string station, title;  ///< empty: nobody
    std::uint64_t term = 0;
    Time heartbeat{};         ///< newest Hold, station's clock
    std::string requestedBy;  ///< station whose request is not answered yet; may be empty
};

/// An alarm as it is now.
struct AlarmState {
    std::uint64_t sequence = 0;  ///< of the newest change
    std::uint64_t raised = 0;    ///< sequence of the newest raising
    std::uint64_t times = 0;     ///< how often it was raised
    AlarmSample alarm;
};

/// A period in which a station wrote the mission.
struct SessionState {
    std::uint64_t started = 0;  ///< sequence
    std::uint64_t ended = 0;    ///< sequence; 0: it runs, or was cut off
    SessionSample session;      ///< its start
};

/// Something that the fold met and that makes no sense; the mission goes on.
struct FoldRemark {
    std::uint64_t sequence = 0;
    std::string text;  ///< in English
};

/// The state of a mission after an event (docs/design.md, "A mission is its log"): a value, cheap to copy.
/// Copies share what they have in common. Equal logs make equal states, bit for bit.
struct MissionState {
    using GrantKey = std::pair<GrantSample::Kind, std::string>;          ///< kind, robot
    using AlarmKey = std::tuple<std::string, std::string, std::string>;  ///< station, robot, key

    std::uint64_t sequence = 0;  ///< last event that is in it
    std::uint64_t events = 0;
    Time first{}, last{};  ///< receive times of the first and of the last event

    std::map<std::string, SharedValue<RobotState>> robots;      ///< by name
    SharedValue<std::map<std::string, StreamState>> ownTopics;  ///< the stations' own topics
    SharedValue<std::vector<Decision>> decisions;               ///< rising sequences
    SharedValue<std::map<FindKey, FindState>> finds;            ///< victims, codes, hazards and other finds
    SharedValue<std::map<std::uint32_t, CandidateState>> candidates;       ///< by id
    SharedValue<std::map<std::uint64_t, KeyScanState>> keyScans;           ///< by id
    SharedValue<std::map<std::uint64_t, LoopState>> loops;                 ///< by id of the link
    SharedValue<std::map<std::uint64_t, std::vector<BodyInScan>>> bodies;  ///< robots, by key scan's id
    SharedValue<std::vector<Latest<NoteSample>>> notes;                    ///< that are not undone
    std::optional<CropState> crop;                                         ///< empty: nobody set one
    SharedValue<std::map<GrantKey, GrantState>> grants;
    SharedValue<std::map<AlarmKey, AlarmState>> alarms;
    SharedValue<std::vector<SessionState>> sessions;
    SharedValue<std::vector<FoldRemark>> remarks;  ///< newest MaxRemarks
    std::optional<Latest<ClockSample>> clock;
    std::optional<Latest<MissionInfoSample>> info;

    static constexpr std::size_t MaxRemarks = 100;
};
using MissionStatePtr = std::shared_ptr<const MissionState>;

/// Returns the position of @p victim in the map now [m]: by the scan it hangs on, otherwise as filed.
[[nodiscard]] Eigen::Vector3d positionInMap(const MissionState& state, const FindSample& victim);
[[nodiscard]] Eigen::Vector3d positionInMap(const MissionState& state, const CandidateSample& candidate);
/// Returns the corners of the area that belongs to the map, as the map is now [m]; empty: none was drawn.
[[nodiscard]] std::vector<Eigen::Vector2d> areaInMap(const MissionState& state);
/// Returns all links that ever closed loops, as they are now: those that are taken back are not active.
[[nodiscard]] std::vector<Link> loopsOf(const MissionState& state);
/// Returns the decision of @p sequence; null when there is none.
[[nodiscard]] const Decision* decisionAt(const MissionState& state, std::uint64_t sequence);

}  // namespace leitstand
