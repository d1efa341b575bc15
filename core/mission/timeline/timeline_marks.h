#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/event/find_sample.h"
#include "core/event/status_samples.h"
#include "core/mission/finds/find_moves.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

struct BumpSample;
struct CandidateSample;
struct SightingSample;
struct Event;

/// A moment of a mission that a reviewer may jump to.
struct TimelineMark {
    enum class Kind : std::uint8_t {
        Victim,     ///< filed or changed; name: "V1", key: "hypothesis", "confirmed", "discarded"
        Candidate,  ///< first published, or dismissed by the operator; key: "told", "dismissed", name:
                    ///< "victim", "hazard", "code", "object", text: its text or the kinds of its cues ("heat,
                    ///< motion")
        Alarm,      ///< raised; key: AlarmSample::key, text: as logged
        Note,       ///< text: what was written
        Decision,   ///< of the operator on scans, or an undo; key: "poses", "undo", "redo" (an undo of an
                    ///< undo); text: UndoSample::text
        Mode,       ///< of a robot; key: ModeSample::mode
        Bump,       ///< key: the bumper
        Moved,      ///< a find moved with its scan; name: "V1", key: "registration", "loop closure",
                    ///< "operator", "undo"; from, to
        Sighting,   ///< a robot's own; key: Sighting::kind, text: of a code
        Session,    ///< a station started or stopped writing; key: "start", "end"; text: its title
    };
    Kind kind = Kind::Note;
    Time at{};                                       ///< station's clock
    std::uint64_t sequence = 0;                      ///< of the event
    std::string robot = {};                          ///< may be empty
    std::string key = {};                            ///< depends on the kind
    std::string name = {};                           ///< depends on the kind
    std::string text = {};                           ///< depends on the kind
    bool act = false;                                ///< an alarm to act on, or a bump
    std::uint32_t candidate = 0;                     ///< CandidateSample::id of a candidate; otherwise 0
    double confidence = Unknown;                     ///< of a candidate when first published, 0 to 1
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< where a moved find was, in the map [m]
    Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< where a moved find is since then [m]
};

/// Collects the marks from a mission's events, which arrive in order. Pure.
class TimelineCollector {
public:
    void add(const Event& event);
    /// Returns the marks found so far, by rising time.
    [[nodiscard]] std::vector<TimelineMark> marks() const;

private:
    void put(const Event& event, TimelineMark mark);
    void addBumps(const Event& event, const BumpSample& bumps);
    void addSightings(const Event& event, const SightingSample& sightings);
    void addMoves(const Event& event);
    void addCandidate(const Event& event, const CandidateSample& candidate);

    std::vector<TimelineMark> m_marks;
    std::map<std::string, std::string> m_modes;                           ///< newest, by robot
    std::map<std::pair<std::string, std::string>, std::uint32_t> m_hits;  ///< by robot and bumper
    std::set<std::pair<std::string, std::uint32_t>> m_sightings;          ///< robot and id
    std::map<std::string, FindSample::Status> m_victims;                  ///< newest, by name
    MissionState m_mission;                                               ///< finds and scans
    FindMoves m_moves;
    std::set<std::uint64_t> m_undos;             ///< sequences of undos that are no redos
    std::map<std::uint32_t, bool> m_candidates;  ///< published ones; whether dismissed
};

/// Removes from @p marks the notes that are undone in @p mission.
void dropUndone(std::vector<TimelineMark>& marks, const MissionState& mission);

/// A stretch of time in which something was recorded.
struct TimelineStretch {
    Time from{}, to{};  ///< both inclusive
    friend bool operator==(const TimelineStretch&, const TimelineStretch&) = default;
};

/// markAfter() returns the first mark later than @p at, markBefore() the last one earlier; null: there is
/// none. @p marks must be sorted by time.
[[nodiscard]] const TimelineMark* markAfter(const std::vector<TimelineMark>& marks, Time at);
[[nodiscard]] const TimelineMark* markBefore(const std::vector<TimelineMark>& marks, Time at);

}  // namespace leitstand
