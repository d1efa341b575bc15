#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/map/moved_places.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/motion/motion_buffer.h"

namespace leitstand {

struct ImuSample;
struct OdometrySample;

/// Where a robot was in the map, as one of its scans shows.
struct MapFix {
    Time stamp{};                       ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< base_link at that time
    double certainty = 0.0;             ///< certainty of the pose, 0 to 1
    bool certain = false;
    std::string how;  ///< English text: how the pose was found
};

/// The pose of the odometry's frame in the map, as a robot's scan shows it. The trail after that scan follows
/// it.
struct TrailAnchor {
    Time since{};                       ///< stamp of the scan, robot's clock
    int frame = 0;                      ///< number of its odometry: MotionBuffer::frameAt()
    Pose odomInMap = Pose::Identity();  ///< pose of the odometry's frame, from the scan
};

/// Continues a robot's pose in the map by its odometry, and keeps its trail. One thread at a time.
class RobotTracker {
public:
    explicit RobotTracker(std::string robot);

    /// A sample without a stamp counts as taken @p now.
    void add(const OdometrySample& odometry, Time now);
    void add(const ImuSample& imu, const Pose& unitInBase, Time now);
    /// Sets where the robot was at the time of @p fix. If odometry does not include that time, the pose is
    /// used for the next odometry that arrives.
    void correct(const MapFix& fix);
    /// Moves the trail after scans moved in the map. A place of the trail moves with the newest of @p anchors
    /// that has the same odometry and is not later than the place. A place without such an anchor stays.
    void layTrail(std::span<const TrailAnchor> anchors);
    /// Moves the robot and its trail together with the places of the map.
    void move(const MovedPlaces& places);
    /// Notes that the robot's pose is no longer known.
    void lose();

    [[nodiscard]] const MotionBuffer& motion() const { return m_motion; }
    [[nodiscard]] bool placed() const { return m_now.odomInMap.has_value(); }
    /// Returns base_link in the map at @p stamp; empty: unknown.
    [[nodiscard]] std::optional<Pose> baseInMap(Time stamp) const;
    /// Returns the pose of the odometry's frame in the map; empty: unknown.
    [[nodiscard]] const std::optional<Pose>& odomInMap() const { return m_now.odomInMap; }
    [[nodiscard]] const RobotInMap& now() const { return m_now; }

private:
    /// A place of the trail.
    struct Footstep {
        Eigen::Vector3f inMap;  ///< place in the map [m]
        Eigen::Vector3d inOdom;
        Time stamp;
        int frame;                             ///< stamp and number of the odometry
        std::chrono::nanoseconds notReceived;  ///< longest time without odometry since the previous place
    };
    void refresh();
    void publishGap();
    void leaveTrail();
    void publishTrail();

    MotionBuffer m_motion;
    std::optional<Time> m_newest;  ///< stamp of the odometry
    /// Pose of base_link in the map, from a fix for which odometry has not arrived yet.
    std::optional<Pose> m_waiting;
    int m_frame = 0;  ///< number of the odometry of odomInMap
    std::vector<Footstep> m_trail;
    double m_spacing;                ///< distance between places of the trail [m]
    std::optional<Time> m_followed;  ///< stamp of the newest odometry that moved the robot in the map
    std::chrono::nanoseconds m_notReceived{};  ///< longest time without odometry since the end of the trail
    RobotInMap m_now;
};

}  // namespace leitstand
