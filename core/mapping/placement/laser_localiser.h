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

/// Settings of LaserLocaliser: when and how far a robot's pose is corrected by its laser.
struct LocaliserSettings {
    std::chrono::nanoseconds every = std::chrono::milliseconds(500);  ///< between views, while it moves ...
    std::chrono::nanoseconds atRest = std::chrono::seconds(3);        ///< ... and while it stands ...
    double way = 0.2;                                                 ///< ... or after this distance [m] ...
    double turn = degrees(15);                                        ///< ... or turn [rad]
    double leastOverlap = 0.5;  ///< least share of what the laser sees that is in the map
    double jump = 0.06;         ///< largest jump against the odometry [m] ...
    double jumpOfWay = 0.2;     ///< ... plus so much per distance since the robot was certain [m / m]
    double sureJump = 0.15,
           sureJumpOfWay = 0.3;      ///< the same where the laser fits beyond doubt: tracks slip
    double swing = degrees(4);       ///< largest turn against the odometry [rad] ...
    double swingOfTurn = 0.3;        ///< ... plus so much per turn [rad / rad] ...
    double swingOfWay = degrees(5);  ///< ... and per distance [rad / m]
    double fades = 1.0;              ///< certainty falls to 1/e over this distance without a fit [m]
    double leastDirection = 0.05;    ///< WallFit::direction; below, the robot is not certain
    double ownOverlap = 0.7;      ///< least share of a view that meets earlier ones, to carry the pose on ...
    double ownDrift = 0.1;        ///< ... and this share of that distance counts as one without a fit
    int searchAfter = 4;          ///< doubted views in a row before the robot is searched for around its pose
    double sureOverlap = 0.65;    ///< least share of the view that is in the map, to be found there ...
    double allOverlap = 0.6;      ///< ... and of what the robot saw on the last metres
    double mostAgainst = 0.25;    ///< largest contradiction() of a place where it is found
    PlacementSettings placement;  ///< settings of the search for the robot
};

/// Keeps a robot with a plane laser localised in the map while it drives. It fits what the laser sees to the
/// map's walls, starting from odometry. A fit that jumps, or that meets too little of the map, is rejected.
/// Then what the laser sees is fitted to its earlier views. If that fails too, odometry carries the robot on,
/// and certainty falls. One thread at a time.
class LaserLocaliser {
public:
    explicit LaserLocaliser(const LocaliserSettings& settings = {}) : m_settings(settings) {}

    /// Begins at @p fix, where the robot was placed.
    void begin(const MapFix& fix);
    /// Returns whether a view of @p stamp is to correct the robot: enough time has passed, or it has moved
    /// enough since the last view. @p motion: how it moved.
    [[nodiscard]] bool due(Time stamp, const MotionBuffer& motion) const;
    /// Corrects the pose by @p view. @p predicted: base_link in the map at the view's stamp by odometry.
    [[nodiscard]] MapFix follow(const LaserView& view, const LocalMap& local, const Pose& predicted,
                                const MotionBuffer& motion);
    /// Forgets earlier views: scans of the map moved, and the robot with them.
    void mapMoved() { m_own.forget(); }
    /// Returns whether the last follow() searched for the robot, and found it away from its pose by odometry.
    [[nodiscard]] bool foundAgain() const { return m_foundAgain; }
    /// Returns whether the robot is lost: views were doubted so often in a row that it was searched for, in
    /// vain.
    [[nodiscard]] bool lost() const { return m_doubted >= m_settings.searchAfter; }
    [[nodiscard]] double overlap() const { return m_overlap; }  ///< of the last view

private:
    /// Returns @p predicted corrected by earlier views and the map; empty: @p view does not fit these.
    [[nodiscard]] std::optional<Pose> carriedOn(const LaserView& view, const WallMap& map,
                                                const Pose& predicted, const Travel& travel) const;
    /// Returns whether the map also has what the laser saw on the last metres, if the robot is at @p found
    /// instead of @p guess.
    [[nodiscard]] bool meetsAll(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                const FlatPose& found) const;
    [[nodiscard]] MapFix sought(const LaserView& view, const LocalMap& local, MapFix doubted);

    LocaliserSettings m_settings;
    MapFix m_last;
    OwnWalls m_own;
    double m_way = 0.0, m_turn = 0.0;  ///< since it was certain [m, rad]
    double m_drift = 0.0;              ///< part of `m_way` by odometry alone: all, or ownDrift of it [m]
    double m_certainty = 0.0;          ///< certainty when the robot was certain last
    double m_overlap = 0.0;
    int m_doubted = 0;  ///< doubted views in a row
    bool m_foundAgain = false;
};

}  // namespace leitstand
