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

/// Where a robot was in the map, by its scans.
struct MapFix {
    Time stamp{};                       ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< at that time
    double certainty = 0.0;             ///< 0 to 1
    bool certain = false;
    std::string how;  ///< in words
};

/// A robot's scan in the map, and the odometry's frame by it. It anchors the part of the trail that follows.
struct TrailAnchor {
    Time since{};                       ///< robot's clock
    int frame = 0;                      ///< number of its odometry: MotionBuffer::frameAt()
    Pose odomInMap = Pose::Identity();  ///< by the scan
};

/// Continues a robot's pose in the map by its odometry, and keeps its trail. One thread at a time.
class RobotTracker {
public:
    explicit RobotTracker(std::string robot);

    /// Samples without a stamp count as taken @p now.
    void add(const OdometrySample& odometry, Time now);
    void add(const ImuSample& imu, const Pose& unitInBase, Time now);
    /// Sets where the robot was at a moment. If odometry does not cover that moment, the robot is taken to be
    /// there when the next odometry arrives.
    void correct(const MapFix& fix);
    /// Moves the trail after scans moved in the map. Each place moves with the newest of @p anchors that is
    /// of the same odometry and not later. A place without such an anchor stays.
    void layTrail(std::span<const TrailAnchor> anchors);
    /// Moves the robot and its trail with the places of the map.
    void move(const MovedPlaces& places);
    /// Notes that the robot's pose is not known any more.
    void lose();

    [[nodiscard]] const MotionBuffer& motion() const { return m_motion; }
    [[nodiscard]] bool placed() const { return m_now.odomInMap.has_value(); }
    /// Returns base_link in the map at @p stamp; empty where it is unknown.
    [[nodiscard]] std::optional<Pose> baseInMap(Time stamp) const;
    /// Returns the odometry's frame in the map; empty where it is unknown.
    [[nodiscard]] const std::optional<Pose>& odomInMap() const { return m_now.odomInMap; }
    [[nodiscard]] const RobotInMap& now() const { return m_now; }

private:
    /// A place of the trail.
    struct Footstep {
        Eigen::Vector3f inMap;  ///< [m]
        Eigen::Vector3d inOdom;
        Time stamp;
        int frame;                             ///< of the odometry
        std::chrono::nanoseconds notReceived;  ///< longest silence of the odometry since the place before
    };
    void refresh();
    void publishGap();
    void leaveTrail();
    void publishTrail();

    MotionBuffer m_motion;
    std::optional<Time> m_newest;   ///< stamp of the odometry
    std::optional<Pose> m_waiting;  ///< base_link in the map, by a fix for which odometry has not come yet
    int m_frame = 0;                ///< of the odometry of odomInMap
    std::vector<Footstep> m_trail;
    double m_spacing;                          ///< of the trail [m]
    std::optional<Time> m_followed;            ///< stamp of the newest odometry that gave its pose in the map
    std::chrono::nanoseconds m_notReceived{};  ///< longest silence of the odometry since the trail's end
    RobotInMap m_now;
};

}  // namespace leitstand
