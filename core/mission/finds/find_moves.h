#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/event/find_sample.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

struct Decision;

/// A find that moved with the scan to which it is attached.
struct FindMove {
    enum class Cause : std::uint8_t {
        Registration,  ///< scans were registered again
        LoopClosure,   ///< a loop was closed
        Operator,      ///< the operator moved, accepted or set aside scans
        Undo,          ///< a decision was undone
    };
    FindKey find{FindSample::Kind::Victim, 0};
    Cause cause = Cause::Registration;
    std::uint64_t sequence = 0;  ///< sequence of the event that moved it
    Time at{};                   ///< when it moved, station's clock
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< places in the map [m]

    [[nodiscard]] double metres() const { return (to - from).norm(); }
};

/// Follows how the finds of a mission move with its scans. Needs only the mission's decisions, so it also
/// works for old missions. Small moves are added up until they exceed LeastMove. Moves by hand are not
/// included.
class FindMoves {
public:
    static constexpr double LeastMove = 0.05;  ///< least move that is reported [m]

    /// Takes the decisions in @p state that are new since the last call, and returns the moves that they
    /// caused. Starts again when @p state belongs to another mission or to an earlier moment.
    std::vector<FindMove> follow(const MissionState& state);
    [[nodiscard]] const std::vector<FindMove>& all() const { return m_all; }  ///< by rising sequence
    /// Returns the newest move of @p find; null: it has not moved since it was filed.
    [[nodiscard]] const FindMove* newest(const FindKey& find) const;

private:
    /// Place of a find when it was last reported, and the entry that placed it there.
    struct Reported {
        FindState entry;
        Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< place in the map [m]
    };
    void take(const Decision& decision);

    MissionState m_replay;  ///< state after the decisions so far
    std::size_t m_taken = 0;
    std::uint64_t m_last = 0;  ///< sequence of the last decision
    std::map<FindKey, Reported> m_reported;
    std::vector<FindMove> m_all;
};

}  // namespace leitstand
