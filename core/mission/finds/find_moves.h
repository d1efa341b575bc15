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

/// A find that moved with the scan it hangs on.
struct FindMove {
    enum class Cause : std::uint8_t {
        Registration,  ///< scans were registered again
        LoopClosure,   ///< a loop was closed
        Operator,      ///< the operator dragged, took or set aside scans
        Undo,          ///< a decision was taken back
    };
    FindKey find{FindSample::Kind::Victim, 0};
    Cause cause = Cause::Registration;
    std::uint64_t sequence = 0;  ///< of the event that moved it
    Time at{};                   ///< station's clock
    Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();  ///< in the map [m]

    [[nodiscard]] double metres() const { return (to - from).norm(); }
};

/// Follows how a mission's finds move with its scans. Needs only the mission's decisions, so that it works
/// for old missions, too. Small moves add up until they exceed LeastMove. Moves by hand do not count.
class FindMoves {
public:
    static constexpr double LeastMove = 0.05;  ///< [m]

    /// Takes the decisions of @p state that are new since the last call, and returns the moves that they
    /// caused. Starts from the beginning when @p state is of another mission or an earlier one.
    std::vector<FindMove> follow(const MissionState& state);
    [[nodiscard]] const std::vector<FindMove>& all() const { return m_all; }  ///< by rising sequence
    /// Returns the newest move of @p find; null: it stayed where it was filed.
    [[nodiscard]] const FindMove* newest(const FindKey& find) const;

private:
    /// Place of a find when it was last reported, and the entry that put it there.
    struct Reported {
        FindState entry;
        Eigen::Vector3d inMap = Eigen::Vector3d::Zero();  ///< [m]
    };
    void take(const Decision& decision);

    MissionState m_replay;  ///< after the decisions taken so far
    std::size_t m_taken = 0;
    std::uint64_t m_last = 0;  ///< sequence of the last decision taken
    std::map<FindKey, Reported> m_reported;
    std::vector<FindMove> m_all;
};

}  // namespace leitstand
