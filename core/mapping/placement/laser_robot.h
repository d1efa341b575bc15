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

/// A robot that does not make the map itself: its laser places it in the map and keeps it localised. Results
/// are samples for the log. Without thread and clock: the caller passes the time of the station's clock. One
/// thread at a time.
class LaserRobot {
public:
    /// @p tracker is corrected; it must outlive this.
    LaserRobot(RobotTracker& tracker, std::string station, const LocaliserSettings& settings = {});

    /// Takes the current view of the laser: a placed robot is localised by it, else it is kept for placing
    /// the robot. The map may be null.
    /// @p others: robots in the map, which the laser sees and the map does not have.
    [[nodiscard]] std::optional<RobotPlaceSample> see(LaserView view, const LiveMapPtr& map, Time now,
                                                      std::span<const Disc> others = {});
    /// Looks for it beside the robot that makes the map, which began at @p otherInMap. What it drove since it
    /// was first heard counts. Empty while there is nothing to report: it was not found, or it is not yet
    /// time for another try.
    [[nodiscard]] std::optional<RobotPlaceSample> placeBeside(const Pose& otherInMap, const LiveMapPtr& map,
                                                              Time now, std::span<const Disc> others = {});
    /// Looks for it, with @p body, where the robot @p by sees something of its size: after it was not found
    /// beside it, or when it is lost. Empty while there is nothing to report.
    [[nodiscard]] std::optional<RobotPlaceSample> placeSeen(std::span<const SeenBody> seen,
                                                            const RobotBody& body, const std::string& by,
                                                            const LiveMapPtr& map, Time now,
                                                            std::span<const Disc> others = {});
    /// Places it at @p baseInMap for the operator and looks for it around there. If it is not found, it
    /// stands there, uncertain.
    [[nodiscard]] RobotPlaceSample place(const Pose& baseInMap, const LiveMapPtr& map, Time now);
    /// The same for the log only: the operator put it there, and its own next 3D scan decides where it
    /// stands. @p measured: the newest scan's moment, its clock.
    [[nodiscard]] RobotPlaceSample putUntilScan(const Pose& baseInMap, Time measured, Time now) const;
    /// The same after it was looked for in the whole map: its 3D scan of @p measured fits there and nowhere
    /// else.
    [[nodiscard]] RobotPlaceSample foundByScan(const Pose& baseInMap, Time measured, double overlap,
                                               Time now) const;
    /// Sets the area of the map. Once the robot is placed, what its laser sees outside does not count.
    void setCrop(MapCrop crop) { m_crop = std::move(crop); }
    /// Notes that scans of the map moved, and the robot with them.
    void mapMoved() { m_localiser.mapMoved(); }
    /// Takes its pose from the log, when the station restarts. It is uncertain until its laser fits there, or
    /// where its odometry went on to.
    void restore(const RobotPlaceSample& place);
    /// Takes its pose from another station, which makes the map.
    void follow(const RobotPlaceSample& place);

    /// Whether its pose is the log's, and not checked since.
    [[nodiscard]] bool resumes() const { return m_resumed.has_value(); }
    [[nodiscard]] bool seesAnything() const { return m_view.has_value(); }
    [[nodiscard]] bool wantsSlot() const { return !m_tracker.placed() && !m_resumed && !m_put; }
    /// Whether placeSeen() is useful.
    [[nodiscard]] bool wantsSeen() const;
    /// Stops using the laser: it sees by 3D scans that are in the map.
    void rest() { m_view.reset(); }

    /// Tries beside the other robot, with a new map or some seconds later, before a failure is reported.
    static constexpr int MostTries = 6;

private:
    /// Records where it was by its odometry at @p stamp.
    void wasAt(Time stamp);
    /// Returns whether what it sees contradicts @p baseInMap, in the local map.
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
    std::optional<LaserView> m_view;  ///< newest
    /// base_link in odom when it was first heard, by the odometry of number m_frame, ...
    std::optional<Pose> m_begin;
    Pose m_newest = Pose::Identity();  ///< ... and at its newest view,
    Pose m_before = Pose::Identity();  ///< and what it drove by earlier odometries, which restarted
    int m_frame = 0;
    std::optional<RobotPlaceSample> m_resumed;
    bool m_put = false;  ///< by the operator, and not found since
    Time m_triedAt{};    ///< robot's clock
    LiveMapPtr m_tried;  ///< the map at that time
    int m_tries = 0;
    LiveMapPtr m_map;  ///< the map of m_local
    LocalMap m_local;
    Pose m_localPlace = Pose::Identity();
};

}  // namespace leitstand
