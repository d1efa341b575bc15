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
#include "core/event/motion_samples.h"
#include "core/mapping/live/map/moved_places.h"
#include "core/mapping/live/robot_in_map.h"
#include "core/mapping/motion/motion_buffer.h"

namespace leitstand {

/// Where a robot was, by its scans.
struct MapFix {
    Time stamp{};                       ///< robot's clock
    Pose baseInMap = Pose::Identity();  ///< then
    double certainty = 0.0;             ///< 0 to 1
    bool certain = false;
    std::string how;  ///< in words
};

/// What a stretch of a robot's way is known by: a scan of its own that is in the map.
struct TrailAnchor {
    Time since{};                       ///< robot's clock
    int frame = 0;                      ///< of its odometry
    Pose odomInMap = Pose::Identity();  ///< as the scan tells
};

/// Carries a robot's place in the map on by its odometry, and keeps its trail. One thread at a time.
class RobotTracker {
public:
    explicit RobotTracker(std::string robot);

    /// Samples without a stamp count as taken @p now.
    void add(const OdometrySample& odometry, Time now);
    void add(const ImuSample& imu, const Pose& unitInBase, Time now);
    /// The robot was there then. Where the odometry does not know that moment, it stands there until it
    /// moves.
    void correct(const MapFix& fix);
    /// Scans moved in the map: each place of the trail moves with the newest of @p anchors before it; what
    /// none tells stays.
    void layTrail(std::span<const TrailAnchor> anchors);
    /// Places of the map moved: the robot and its trail go with them.
    void move(const MovedPlaces& places);
    /// Nobody knows where the robot is any more.
    void lose();

    [[nodiscard]] const MotionBuffer& motion() const { return m_motion; }
    [[nodiscard]] bool placed() const { return m_now.odomInMap.has_value(); }
    /// base_link in the map at @p stamp; empty where nobody knows.
    [[nodiscard]] std::optional<Pose> baseInMap(Time stamp) const;
    /// Where the odometry's frame lies in the map; empty where nobody knows.
    [[nodiscard]] const std::optional<Pose>& odomInMap() const { return m_now.odomInMap; }
    [[nodiscard]] const RobotInMap& now() const { return m_now; }

private:
    /// A place of the trail.
    struct Footstep {
        Eigen::Vector3f inMap;  ///< [m]
        Eigen::Vector3d inOdom;
        Time stamp;
        int frame;                         ///< of the odometry
        std::chrono::nanoseconds unheard;  ///< longest silence of the odometry since the place before
    };
    void refresh();
    void tellGap();
    void leaveTrail();
    void tellTrail();

    MotionBuffer m_motion;
    std::optional<Time> m_newest;   ///< odometry
    std::optional<Pose> m_waiting;  ///< base_link in the map: the fix came before the odometry
    int m_frame = 0;                ///< of the odometry that odomInMap is of
    std::vector<Footstep> m_trail;
    double m_spacing;                      ///< of the trail [m]
    std::optional<Time> m_followed;        ///< odometry that told its place in the map, the newest
    std::chrono::nanoseconds m_unheard{};  ///< longest silence of the odometry since the trail's end
    RobotInMap m_now;
};

}  // namespace leitstand
