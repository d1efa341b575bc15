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

/// Settings of LaserLocaliser: when a robot's pose is corrected by its laser, and how far.
struct LocaliserSettings {
    /// Time between views while the robot moves ...
    std::chrono::nanoseconds every = std::chrono::milliseconds(500);
    std::chrono::nanoseconds atRest = std::chrono::seconds(3);  ///< ... and while it stands ...
    double way = 0.2;           ///< ... or earlier, after driving this far [m] ...
    double turn = degrees(15);  ///< ... or turning this far [rad]
    double leastOverlap = 0.5;  ///< least share of the view that must fit the map
    double jump = 0.06;         ///< largest correction of odometry's position [m] ...
    double jumpOfWay = 0.2;     ///< ... plus this much per distance since the robot was certain [m / m]
    double sureJump = 0.15,
           sureJumpOfWay = 0.3;      ///< the same if the laser fits very well, since tracks slip
    double swing = degrees(4);       ///< largest correction of odometry's heading [rad] ...
    double swingOfTurn = 0.3;        ///< ... plus this much per turn [rad / rad] ...
    double swingOfWay = degrees(5);  ///< ... and per distance [rad / m]
    double fades = 1.0;              ///< without a fit, certainty falls to 1/e over this distance [m]
    double leastDirection = 0.05;    ///< least WallFit::direction at which the robot is certain
    /// Least share of a view that must fit earlier views to continue the pose by them ...
    double ownOverlap = 0.7;
    double ownDrift = 0.1;  ///< ... then only this share of the distance counts as driven without a fit
    /// Number of doubtful views in a row after which the robot is searched for around its pose.
    int searchAfter = 4;
    double sureOverlap = 0.65;    ///< the search succeeds if at least this share of the view fits the map ...
    double allOverlap = 0.6;      ///< ... and this share of all that the robot saw over the last metres
    double mostAgainst = 0.25;    ///< largest contradiction() at a place where the robot is found
    PlacementSettings placement;  ///< settings of the search for the robot
};

/// Keeps a robot with a plane laser localised in the map while it drives. What the laser sees is fitted to
/// the map's walls, starting from odometry. A fit is rejected if it jumps, or if too little of the view fits
/// the map. Then the view is fitted to earlier views. If that fails too, only odometry continues the pose,
/// and certainty falls. One thread at a time.
class LaserLocaliser {
public:
    explicit LaserLocaliser(const LocaliserSettings& settings = {}) : m_settings(settings) {}

    /// Begins at @p fix, where the robot was placed.
    void begin(const MapFix& fix);
    /// Returns whether a view at @p stamp should correct the robot: enough time has passed since the last
    /// view, or the robot has moved enough. @p motion: how it moved.
    [[nodiscard]] bool due(Time stamp, const MotionBuffer& motion) const;
    /// Corrects the pose by @p view. @p predicted: base_link in the map at the view's stamp, by odometry.
    [[nodiscard]] MapFix follow(const LaserView& view, const LocalMap& local, const Pose& predicted,
                                const MotionBuffer& motion);
    /// Forgets earlier views, because scans of the map moved, and the robot with them.
    void mapMoved() { m_own.forget(); }
    /// Returns whether the last follow() searched for the robot and found it away from its pose by odometry.
    [[nodiscard]] bool foundAgain() const { return m_foundAgain; }
    /// Returns whether the robot is lost: after several doubtful views in a row it was searched for, but not
    /// found.
    [[nodiscard]] bool lost() const { return m_doubted >= m_settings.searchAfter; }
    [[nodiscard]] double overlap() const { return m_overlap; }  ///< overlap of the last view

private:
    /// Returns @p predicted corrected by earlier views and the map; empty: @p view does not fit them.
    [[nodiscard]] std::optional<Pose> carriedOn(const LaserView& view, const WallMap& map,
                                                const Pose& predicted, const Travel& travel) const;
    /// Returns whether the map also fits what the laser saw over the last metres, if the robot is at @p found
    /// and not at @p guess.
    [[nodiscard]] bool meetsAll(const LaserView& view, const WallMap& map, const FlatPose& guess,
                                const FlatPose& found) const;
    [[nodiscard]] MapFix sought(const LaserView& view, const LocalMap& local, MapFix doubted);

    LocaliserSettings m_settings;
    MapFix m_last;
    OwnWalls m_own;
    double m_way = 0.0, m_turn = 0.0;  ///< distance and turn since the robot was certain [m, rad]
    /// Part of `m_way` that counts as odometry alone: all of it, or the share ownDrift [m].
    double m_drift = 0.0;
    double m_certainty = 0.0;  ///< certainty when the robot was last certain
    double m_overlap = 0.0;
    int m_doubted = 0;  ///< number of doubtful views in a row
    bool m_foundAgain = false;
};

}  // namespace leitstand
