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

/// A moment of a mission that a reviewer may want to jump to.
struct TimelineMark {
    enum class Kind : std::uint8_t {
        Victim,  ///< a victim was filed or changed; name: "V1", key: "hypothesis", "confirmed", "discarded"
        /// A candidate was first published, or dismissed by the operator; key: "told", "dismissed"; name:
        /// "victim", "hazard", "code", "object"; text: its text, or the kinds of its cues ("heat, motion").
        Candidate,
        Alarm,  ///< an alarm was raised; key: AlarmSample::key, text: as logged
        Note,   ///< a note; text: what was written
        /// A decision of the operator about scans, or an undo; key: "poses", "undo", "redo" (an undo of an
        /// undo); text: UndoSample::text.
        Decision,
        Mode,      ///< a robot's mode changed; key: ModeSample::mode
        Bump,      ///< a bumper was hit; key: the bumper
        Moved,     ///< a find moved with its scan; name: "V1", key: "registration", "loop closure",
                   ///< "operator", "undo"; from, to
        Sighting,  ///< a robot's own sighting; key: Sighting::kind, text: text of a code
        Session,   ///< a station started or stopped writing; key: "start", "end"; text: its title
    };
    Kind kind = Kind::Note;
    Time at{};                    ///< when it happened, station's clock
    std::uint64_t sequence = 0;   ///< sequence of the event
    std::string robot = {};       ///< may be empty
    std::string key = {};         ///< depends on the kind
    std::string name = {};        ///< depends on the kind
    std::string text = {};        ///< depends on the kind
    bool act = false;             ///< an alarm that needs action, or a bump
    std::uint32_t candidate = 0;  ///< CandidateSample::id; 0 for other marks
    double confidence = Unknown;  ///< confidence of a candidate when it was first published, 0 to 1
    Eigen::Vector3d from = Eigen::Vector3d::Zero();  ///< where a moved find was before, in the map [m]
    Eigen::Vector3d to = Eigen::Vector3d::Zero();    ///< where a moved find is now, in the map [m]
};

/// Collects the marks from a mission's events, which must arrive in order. Pure.
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
    std::map<std::string, std::string> m_modes;  ///< newest mode, by robot
    /// Number of hits, by robot and bumper.
    std::map<std::pair<std::string, std::string>, std::uint32_t> m_hits;
    std::set<std::pair<std::string, std::uint32_t>> m_sightings;  ///< known sightings: robot and id
    std::map<std::string, FindSample::Status> m_victims;          ///< newest status, by name
    MissionState m_mission;                                       ///< state of finds and scans
    FindMoves m_moves;
    std::set<std::uint64_t> m_undos;             ///< sequences of undos that are no redos
    std::map<std::uint32_t, bool> m_candidates;  ///< published candidates, and whether each is dismissed
};

/// Removes from @p marks the notes that are undone in @p mission.
void dropUndone(std::vector<TimelineMark>& marks, const MissionState& mission);

/// A period in which something was recorded.
struct TimelineStretch {
    Time from{}, to{};  ///< both ends included
    friend bool operator==(const TimelineStretch&, const TimelineStretch&) = default;
};

/// markAfter() returns the first mark after @p at, markBefore() the last mark before it; null: there is none.
/// @p marks must be sorted by time.
[[nodiscard]] const TimelineMark* markAfter(const std::vector<TimelineMark>& marks, Time at);
[[nodiscard]] const TimelineMark* markBefore(const std::vector<TimelineMark>& marks, Time at);

}  // namespace leitstand
