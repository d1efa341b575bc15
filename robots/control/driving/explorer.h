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
    double turnCost = 0.0;    ///< cost of half a turn towards the unseen, as a distance [m]
    double aimAhead = 0.7;    ///< distance of the point to aim at along the way [m]
    double goalNear = 0.5;    ///< an unreachable goal is treated as reached at this distance [m]
    double arrived = 0.25;    ///< a goal is reached at this distance [m]
    double stuckAfter = 6.0;  ///< the robot is stuck after this time without progress [s]
    double recoverFor = 2.5;  ///< time that it backs off or turns [s]
    double blindAfter = 3.5;  ///< the robot stands if there was no raw scan for this long [s]
    double lookFirst = 5.0;   ///< at first it stands and looks for this long: two turns of the scanner [s]
    double replan = 0.5;      ///< period of planning [s]
    double patience = 30.0;   ///< time allowed for one point to aim at, in addition to a slow drive to it [s]
    /// How long it waits before it looks for a way again, up to two times [s], since another robot may be in
    /// the way.
    double waitForOthers = 12.0;
};

/// One step of exploring.
struct ExplorerStep {
    DriveVelocity velocity;
    bool done = false;                 ///< the goal is reached, or everything was seen
    bool failed = false;               ///< there is no way to the goal
    std::string reason;                ///< English text: what it is doing
    std::vector<Eigen::Vector3d> way;  ///< planned way in odom, on the floor [m]
};

/// Drives by itself to the nearest unseen place, or to a goal. Fuzzy control drives the next metre; the
/// memory of the floor decides where to go. Gets out of dead ends by itself. Pure: times are passed in.
class Explorer {
public:
    Explorer(FuzzyDrive drive, const ExplorerSettings& settings = {});

    /// Sets the goal in odom, at the height of the floor there [m]; empty: explore. A goal comes from
    /// goal_pose, or leads back to the link.
    void setGoal(const std::optional<Eigen::Vector3d>& goal);
    [[nodiscard]] const std::optional<Eigen::Vector3d>& goal() const { return m_goal; }
    /// Starts again after another driver. The memory of the floor is kept.
    void resume();

    /// @p newest: VirtualScan::newest(). Call at least 10 times a second.
    [[nodiscard]] ExplorerStep step(const VirtualScanView& view, const Pose& baseInOdom,
                                    const std::optional<Time>& newest, Time now);
    /// Updates the memory of the floor while another driver drives.
    void see(const VirtualScanView& view, const Pose& baseInOdom, Time now);
    /// Stays @p radius [m] away from @p place in odom [m] where possible, since a victim may move.
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
    Eigen::Vector2d m_progress = Eigen::Vector2d::Zero();  ///< place at m_progressAt, in odom [m]
    Time m_patience{};  ///< when it stops trying to reach the end of its way
    int m_emptyPlans = 0;
    std::optional<Time> m_doubted;  ///< since when it has found no way and looked again
    int m_doubts = 0;               ///< number of doubts since it saw something new
    double m_seenThen = 0.0;        ///< seen area at the last doubt [m2]
    int m_recoveries = 0;
    DriveVelocity m_recovery;
};

}  // namespace leitstand
