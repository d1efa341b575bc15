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
    double turnCost = 0.0;    ///< extra cost of half a turn towards the unseen, as a length of way [m]
    double aimAhead = 0.7;    ///< distance of the aim along the way [m]
    double goalNear = 0.5;    ///< an unreachable goal counts as reached at this distance [m]
    double arrived = 0.25;    ///< distance at which a goal is reached [m]
    double stuckAfter = 6.0;  ///< time without progress [s]
    double recoverFor = 2.5;  ///< time that it backs off or turns [s]
    double blindAfter = 3.5;  ///< stands when there was no raw scan for so long [s]
    double lookFirst = 5.0;   ///< stands and looks for so long at first: two turns of the scanner [s]
    double replan = 0.5;      ///< period of planning [s]
    double patience = 30.0;   ///< time for one aim, on top of a slow drive to it [s]
    /// Waits so long before it looks for a way again, up to two times [s]: another robot may stand in the
    /// way.
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

/// Drives by itself to the nearest unseen place, or to a goal. Fuzzy control drives the next metre, the
/// memory of the floor chooses where to go. Gets out of dead ends by itself. Pure: times are passed in.
class Explorer {
public:
    Explorer(FuzzyDrive drive, const ExplorerSettings& settings = {});

    /// Sets the goal in odom, at the height of the floor there [m]; empty: explores. A goal comes by
    /// goal_pose, or leads back to the link.
    void setGoal(const std::optional<Eigen::Vector3d>& goal);
    [[nodiscard]] const std::optional<Eigen::Vector3d>& goal() const { return m_goal; }
    /// Starts again after another driver; keeps its memory of the floor.
    void resume();

    /// @p newest: VirtualScan::newest(). Call it 10 times a second or more.
    [[nodiscard]] ExplorerStep step(const VirtualScanView& view, const Pose& baseInOdom,
                                    const std::optional<Time>& newest, Time now);
    /// Updates the memory of the floor while another drives.
    void see(const VirtualScanView& view, const Pose& baseInOdom, Time now);
    /// Keeps away from @p place in odom [m] where it can: a victim may move.
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
    Eigen::Vector2d m_progress = Eigen::Vector2d::Zero();  ///< place at m_progressAt, odom [m]
    Time m_patience{};  ///< until then it tries to reach the end of its way
    int m_emptyPlans = 0;
    std::optional<Time> m_doubted;  ///< since when it finds no way and looks again
    int m_doubts = 0;               ///< doubts since it saw something new
    double m_seenThen = 0.0;        ///< seen area at the last doubt [m2]
    int m_recoveries = 0;
    DriveVelocity m_recovery;
};

}  // namespace leitstand
