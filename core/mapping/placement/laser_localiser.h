#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/motion/motion_buffer.h"
#include "core/mapping/placement/laser_view.h"
#include "core/mapping/placement/own_walls.h"
#include "core/mapping/placement/placement.h"

namespace leitstand {

/// When and how far a robot's place is corrected by its laser.
struct LocaliserSettings {
    std::chrono::nanoseconds every = std::chrono::milliseconds(500);  ///< while it moves ...
    std::chrono::nanoseconds atRest = std::chrono::seconds(3);        ///< ... and while it stands
    double way = 0.2;                                                 ///< ... or after so much [m] ...
    double turn = degrees(15);                                        ///< ... or [rad]
    double leastOverlap = 0.5;                    ///< of what the laser sees, with the map
    double jump = 0.06;                           ///< against the odometry [m] ...
    double jumpOfWay = 0.2;                       ///< ... and so much of the way since it was certain
    double sureJump = 0.15, sureJumpOfWay = 0.3;  ///< the same where the laser fits beyond doubt: tracks slip
    double swing = degrees(4);                    ///< likewise [rad] ...
    double swingOfTurn = 0.3;                     ///< ... of the turn
    double swingOfWay = degrees(5);               ///< ... [rad / m]
    double fades = 1.0;                           ///< certainty falls to 1/e on so much way without a fit [m]
    double leastDirection = 0.05;                 ///< WallFit::direction: with less, the robot is not certain
    double ownOverlap = 0.7;  ///< of what the laser sees with what it saw before: it carries the robot on ...
    double ownDrift = 0.1;    ///< ... which counts as so much of its way without a fit
    int searchAfter = 4;      ///< doubts in a row, then it is looked for in a window
    double sureOverlap = 0.65;    ///< least of what it sees with the map, to be found there ...
    double allOverlap = 0.6;      ///< ... and of what it saw on the last metres
    double mostAgainst = 0.25;    ///< contradiction() of a place where it is found
    PlacementSettings placement;  ///< how it is looked for
};

/// Keeps a robot that has a plane laser where it is in the map while it drives: what the laser sees is laid
/// onto the map's walls, from where the odometry carried the robot. A fit that jumps, or that meets too
/// little of the map, is no fit: then what the laser sees is laid onto what it saw before, and where that
/// does not fit either, the odometry goes on; certainty falls. One thread at a time.
class LaserLocaliser {
public:
    explicit LaserLocaliser(const LocaliserSettings& settings = {}) : m_settings(settings) {}

    /// The robot was placed.
    void begin(const MapFix& fix);
    /// Whether it is time for another view at @p stamp, of a robot that moved as @p motion tells.
    [[nodiscard]] bool due(Time stamp, const MotionBuffer& motion) const;
    /// @p predicted: base_link in the map at the view's stamp by odometry.
    [[nodiscard]] MapFix follow(const LaserView& view, const LocalMap& local, const Pose& predicted,
                                const MotionBuffer& motion);
    /// Scans of the map moved, and the robot with them: what it saw before lies elsewhere now.
    void mapMoved() { m_own.forget(); }
    /// Whether the last follow() found the robot elsewhere than its odometry had it.
    [[nodiscard]] bool foundAgain() const { return m_foundAgain; }
    /// Whether it was looked for about where its odometry has it, in vain.
    [[nodiscard]] bool lost() const { return m_doubted >= m_settings.searchAfter; }
    [[nodiscard]] double overlap() const { return m_overlap; }  ///< of the last view

private:
    /// Where @p predicted is by what the laser saw before and what the map has; empty: neither tells.
    [[nodiscard]] std::optional<Pose> carriedOn(const LaserView& view, const WallMap& map,
                                                const Pose& predicted, const Travel& travel) const;
    /// Whether the map has what the laser saw on the last metres, too, if the robot that was taken to be at
    /// @p guess is at @p found.
    [[nodiscard]] bool meetsAll(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                const FlatPose& found) const;
    [[nodiscard]] MapFix sought(const LaserView& view, const LocalMap& local, MapFix doubted);

    LocaliserSettings m_settings;
    MapFix m_last;
    OwnWalls m_own;
    double m_way = 0.0, m_turn = 0.0;  ///< since it was certain [m, rad]
    double m_drift = 0.0;      ///< of that way, what nothing but odometry tells: all, or ownDrift of it [m]
    double m_certainty = 0.0;  ///< then
    double m_overlap = 0.0;
    int m_doubted = 0;  ///< views in a row
    bool m_foundAgain = false;
};

}  // namespace leitstand
