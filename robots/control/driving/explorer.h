#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "robots/control/driving/floor_memory.h"
#include "robots/control/driving/fuzzy_drive.h"

namespace leitstand {

struct ExplorerSettings {
    FloorMemorySettings memory;
    double turnCost = 0.0;    ///< half a turn to the unseen is as bad as so long a way [m]
    double aimAhead = 0.7;    ///< along the way [m]
    double goalNear = 0.5;    ///< of a goal that cannot be reached itself [m]
    double arrived = 0.25;    ///< from a goal [m]
    double stuckAfter = 6.0;  ///< without getting on [s]
    double recoverFor = 2.5;  ///< backs off or turns [s]
    double blindAfter = 3.5;  ///< without a raw scan it stands [s]
    double lookFirst = 5.0;   ///< at the beginning: two turns of the scanner [s]
    double replan = 0.5;      ///< [s]
    double patience = 30.0;   ///< with one aim, beside the time of a slow drive to it [s]
    /// Without a way it looks again, so long each of two times: another robot may stand in it [s].
    double waitForOthers = 12.0;
};

/// One step of exploring.
struct ExplorerStep {
    DriveVelocity velocity;
    bool done = false;                 ///< at the goal, or nothing is left to see
    bool failed = false;               ///< no way to the goal
    std::string reason;                ///< what it is doing, in words
    std::vector<Eigen::Vector3d> way;  ///< planned, in odom, on the floor [m]
};

/// Drives by itself: fuzzy control for the next metre, the memory of the floor for where to go: to the
/// nearest unseen place, or to a goal. Comes out of dead ends by itself. Pure: times are passed in.
class Explorer {
public:
    Explorer(FuzzyDrive drive, const ExplorerSettings& settings = {});

    /// To @p goal in odom, on its floor (goal_pose, the way back to the link) [m]; empty: explores.
    void setGoal(const std::optional<Eigen::Vector3d>& goal);
    [[nodiscard]] const std::optional<Eigen::Vector3d>& goal() const { return m_goal; }
    /// Begins anew after another driver: keeps what it remembers of the floor.
    void resume();

    /// @p newest: VirtualScan::newest(). To be called 10 times a second or more.
    [[nodiscard]] ExplorerStep step(const VirtualScanView& view, const Pose& baseInOdom,
                                    const std::optional<Time>& newest, Time now);
    /// Looks on while another drives.
    void see(const VirtualScanView& view, const Pose& baseInOdom, Time now);
    /// Keeps off @p place in odom, where it can: a victim may move [m].
    void shun(const Eigen::Vector3d& place, double radius) { m_memory.shun(place, radius); }
    [[nodiscard]] const FloorMemory& memory() const { return m_memory; }

private:
    [[nodiscard]] std::optional<DriveVelocity> recover(const VirtualScanView& view, const Pose& baseInOdom,
                                                       Time now, bool wantsToMove);
    void plan(const Pose& baseInOdom, Time now);
    [[nodiscard]] bool looksAgain(const Pose& baseInOdom, Time now);
    [[nodiscard]] std::optional<Eigen::Vector2d> aim(const Pose& baseInOdom) const;

    FuzzyDrive m_drive;
    ExplorerSettings m_settings;
    FloorMemory m_memory;
    std::optional<Eigen::Vector3d> m_goal;
    std::vector<Eigen::Vector3d> m_way;
    std::optional<Time> m_planned, m_seen, m_progressAt, m_recoverUntil;
    Eigen::Vector2d m_progress = Eigen::Vector2d::Zero();  ///< place of then [m]
    Time m_patience{};  ///< until then it tries to come to where its way ends
    int m_emptyPlans = 0;
    std::optional<Time> m_doubted;  ///< found no way, and looks again since
    int m_doubts = 0;               ///< since it saw something new
    double m_seenThen = 0.0;        ///< at the last doubt [m2]
    int m_recoveries = 0;
    DriveVelocity m_recovery;
};

}  // namespace leitstand
