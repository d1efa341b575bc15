#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/mission/state/robot_state.h"
#include "core/mission/state/shared_value.h"

namespace leitstand {

struct AlarmState;
struct BodyInScan;
struct CandidateSample;
struct CandidateState;
struct ClockSample;
struct CropState;
struct Decision;
struct FindSample;
struct FindState;
struct KeyScanState;
struct Link;
struct LoopState;
struct MissionInfoSample;
struct NoteSample;
struct SessionState;
enum class FindKind : std::uint8_t;
enum class GrantKind : std::uint8_t;

/// Identifies a victim or another find.
using FindKey = std::pair<FindKind, std::uint32_t>;  ///< kind, number

/// Who holds a grant.
struct GrantState {
    std::string station, title;  ///< empty: nobody
    std::uint64_t term = 0;
    Time heartbeat{};         ///< stamp of the newest Hold, station's clock
    std::string requestedBy;  ///< station whose request is not answered yet; may be empty
};

/// Something in the events that makes no sense. The mission continues.
struct FoldRemark {
    std::uint64_t sequence = 0;
    std::string text;  ///< in English
};

/// The state of a mission after an event (docs/design.md, "A mission is its log"). It is a value and cheap to
/// copy: copies share what they have in common. Equal logs give equal states, bit for bit. Code that reads a
/// part of it includes that part's header: decision.h, find_state.h, scan_state.h, crop_state.h,
/// session_state.h.
struct MissionState {
    MissionState();  ///< Creates the state of a mission without events.

    using GrantKey = std::pair<GrantKind, std::string>;                  ///< kind, robot
    using AlarmKey = std::tuple<std::string, std::string, std::string>;  ///< station, robot, key

    std::uint64_t sequence = 0;  ///< sequence of the last event
    std::uint64_t events = 0;
    Time first{}, last{};  ///< receive times of the first and of the last event

    std::map<std::string, SharedValue<RobotState>> robots;      ///< by name
    SharedValue<std::map<std::string, StreamState>> ownTopics;  ///< the stations' own topics
    SharedValue<std::vector<Decision>> decisions;               ///< by rising sequence
    SharedValue<std::map<FindKey, FindState>> finds;            ///< victims, codes, hazards and other finds
    SharedValue<std::map<std::uint32_t, CandidateState>> candidates;  ///< by id
    SharedValue<std::map<std::uint64_t, KeyScanState>> keyScans;      ///< by id
    SharedValue<std::map<std::uint64_t, LoopState>> loops;            ///< by id of the link
    /// Other robots seen in a key scan, by its id.
    SharedValue<std::map<std::uint64_t, std::vector<BodyInScan>>> bodies;
    SharedValue<std::vector<Latest<NoteSample>>> notes;  ///< notes that are not undone
    std::shared_ptr<const CropState> crop;               ///< null: nobody set one
    SharedValue<std::map<GrantKey, GrantState>> grants;
    SharedValue<std::map<AlarmKey, AlarmState>> alarms;
    SharedValue<std::vector<SessionState>> sessions;
    SharedValue<std::vector<FoldRemark>> remarks;  ///< newest remarks, at most MaxRemarks
    LatestPtr<ClockSample> clock;
    LatestPtr<MissionInfoSample> info;

    static constexpr std::size_t MaxRemarks = 100;
};
using MissionStatePtr = std::shared_ptr<const MissionState>;

/// Returns where @p victim is in the map now [m]. It moves with the scan that it is attached to. If there is
/// none, it is where it was filed.
[[nodiscard]] Eigen::Vector3d positionInMap(const MissionState& state, const FindSample& victim);
[[nodiscard]] Eigen::Vector3d positionInMap(const MissionState& state, const CandidateSample& candidate);
/// Returns the corners of the area that belongs to the map, in the map as it is now [m]; empty: no area was
/// drawn.
[[nodiscard]] std::vector<Eigen::Vector2d> areaInMap(const MissionState& state);
/// Returns all links that ever closed loops, with their present state: those that were removed are not
/// active.
[[nodiscard]] std::vector<Link> loopsOf(const MissionState& state);
/// Returns the decision with the sequence @p sequence; null when there is none.
[[nodiscard]] const Decision* decisionAt(const MissionState& state, std::uint64_t sequence);

}  // namespace leitstand
