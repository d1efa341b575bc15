#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/map_samples.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/robot_tracker.h"
#include "core/mapping/placement/laser_localiser.h"
#include "core/mapping/placement/laser_view.h"
#include "core/mapping/sighting/seen_bodies.h"

namespace leitstand {

/// A robot that does not make the map itself. Its laser finds its pose in the map and keeps it correct.
/// Results are samples for the log. It has no thread and no clock: the caller passes the time of the
/// station's clock. One thread at a time.
class LaserRobot {
public:
    /// @p tracker is corrected; it must outlive this object.
    LaserRobot(RobotTracker& tracker, std::string station, const LocaliserSettings& settings = {});

    /// Takes the newest view of the laser. If the robot is placed, the view corrects its pose; otherwise the
    /// view is kept to place it. Returns the result for the log; empty: none. @p map may be null. @p others:
    /// where other robots stand, which the laser sees although they are not in the map.
    [[nodiscard]] std::optional<RobotPlaceSample> see(LaserView view, const LiveMapPtr& map, Time now,
                                                      std::span<const Disc> others = {});
    /// Searches for the robot beside the one that makes the map, which started at @p otherInMap. How far the
    /// robot has driven since it was first heard is added. Empty: it was not found yet, or it is too early
    /// for another try. After MostTries, returns the failure.
    [[nodiscard]] std::optional<RobotPlaceSample> placeBeside(const Pose& otherInMap, const LiveMapPtr& map,
                                                              Time now, std::span<const Disc> others = {});
    /// Searches for the robot, whose shape is @p body, at the places @p seen where the robot @p by sees
    /// something of its size. Useful after placeBeside() failed, or when the robot is lost. Empty: nothing to
    /// report.
    [[nodiscard]] std::optional<RobotPlaceSample> placeSeen(std::span<const SeenBody> seen,
                                                            const RobotBody& body, const std::string& by,
                                                            const LiveMapPtr& map, Time now,
                                                            std::span<const Disc> others = {});
    /// The operator places the robot at @p baseInMap. Searches for the robot around there. If it is not
    /// found, it is placed at @p baseInMap, uncertain.
    [[nodiscard]] RobotPlaceSample place(const Pose& baseInMap, const LiveMapPtr& map, Time now);
    /// Returns a sample for the log only. It says that the operator placed the robot at @p baseInMap, and
    /// that its next 3D scan decides where it is. @p measured: end of its newest scan, robot's clock.
    [[nodiscard]] RobotPlaceSample putUntilScan(const Pose& baseInMap, Time measured, Time now) const;
    /// As above, for a robot that was looked for in the whole map. Its 3D scan at @p measured fits at
    /// @p baseInMap and nowhere else. @p overlap: share of that scan that fits the map.
    [[nodiscard]] RobotPlaceSample foundByScan(const Pose& baseInMap, Time measured, double overlap,
                                               Time now) const;
    /// Sets the area of the map. When the robot is placed, points that its laser sees outside are ignored.
    void setCrop(MapCrop crop) { m_crop = std::move(crop); }
    /// Notes that scans of the map moved, and the robot with them.
    void mapMoved() { m_localiser.mapMoved(); }
    /// Takes the robot's pose from the log, when the station restarts. The pose is uncertain until the laser
    /// fits there, or at the place to which odometry has led since.
    void restore(const RobotPlaceSample& place);
    /// Takes the robot's pose from another station, which makes the map.
    void follow(const RobotPlaceSample& place);

    /// Returns whether the robot's pose came from the log or another station, and was not checked since.
    [[nodiscard]] bool resumes() const { return m_resumed.has_value(); }
    [[nodiscard]] bool seesAnything() const { return m_view.has_value(); }
    [[nodiscard]] bool wantsSlot() const { return !m_tracker.placed() && !m_resumed && !m_put; }
    /// Returns whether placeSeen() would be useful.
    [[nodiscard]] bool wantsSeen() const;
    /// Stops using the laser, because the robot's own 3D scans are in the map now.
    void rest() { m_view.reset(); }

    /// Number of tries of placeBeside() before it reports a failure. Between tries the map has changed, or
    /// some seconds have passed.
    static constexpr int MostTries = 6;

private:
    /// Records where the robot was by its odometry at @p stamp.
    void wasAt(Time stamp);
    /// Returns whether the newest view contradicts @p baseInMap, given the local map.
    [[nodiscard]] bool contradicted(const Pose& baseInMap, std::span<const Disc> others) const;
    [[nodiscard]] const LocalMap& localAt(const LiveMapPtr& map, const Pose& place);
    [[nodiscard]] RobotPlaceSample taken(const MapFix& fix, RobotPlaceSample::Cause cause, double overlap,
                                         Time now);
    [[nodiscard]] std::optional<RobotPlaceSample> resumed(const LiveMapPtr& map, Time now);

    RobotTracker& m_tracker;
    std::string m_station;
    LocaliserSettings m_settings;
    LaserLocaliser m_localiser;
    MapCrop m_crop;
    std::optional<LaserView> m_view;  ///< newest view
    /// base_link in odom when it was first heard, in the odometry with number m_frame ...
    std::optional<Pose> m_begin;
    Pose m_newest = Pose::Identity();  ///< ... and at its newest view ...
    /// ... and how far it drove in earlier odometries, before they restarted.
    Pose m_before = Pose::Identity();
    int m_frame = 0;
    std::optional<RobotPlaceSample> m_resumed;
    bool m_put = false;  ///< whether the operator placed it, and it was not found since
    Time m_triedAt{};    ///< time of the last try, robot's clock
    LiveMapPtr m_tried;  ///< the map at that time
    int m_tries = 0;
    LiveMapPtr m_map;  ///< map from which m_local was made
    LocalMap m_local;
    Pose m_localPlace = Pose::Identity();
};

}  // namespace leitstand
