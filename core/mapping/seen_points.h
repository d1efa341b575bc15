#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand {

struct CloudSample;
struct RangesSample;

/// Where a ray meets a surface that a scanner saw.
struct RayHit {
    double range = 0.0;    ///< distance from the ray's origin [m]
    double scatter = 0.0;  ///< standard deviation of the ranges of the points that were met [m]
    int points = 0;
};

/// What a robot's scanners saw in the last seconds, in the odometry's frame. Rays of its cameras are
/// intersected with these points. One thread.
class SeenPoints {
public:
    using PoseAt = std::function<std::optional<Pose>(Time)>;
    static constexpr std::chrono::milliseconds Memory{4000};

    /// Points on the robot's own @p body are left out.
    explicit SeenPoints(RobotBody body = {});

    /// Adds what a scanner saw. @p baseInOdom returns the robot's pose at a time. Points at times for which
    /// it returns nothing are left out.
    void add(const CloudSample& slice, const Pose& sensorInBase, const PoseAt& baseInOdom);
    void add(const RangesSample& turn, const Pose& sensorInBase, const PoseAt& baseInOdom);
    void clear() { m_chunks.clear(); }

    /// Returns whether the picture shows the sought object in a direction (odometry's frame, of unit length).
    using Shows = std::function<bool(const Eigen::Vector3d&)>;

    /// Returns where @p ray (odometry's frame) meets a surface: the nearest surface with many of the points
    /// within @p halfAngle [rad] around the ray. If this cone holds too few points, it is widened up to three
    /// times. Points in directions for which @p shows returns false are ignored; @p shows may be empty. Empty
    /// result: no surface within @p farthest [m].
    [[nodiscard]] std::optional<RayHit> meet(const Ray& ray, double halfAngle, double farthest = 9.0,
                                             const Shows& shows = {}) const;

private:
    struct Chunk {
        Time stamp;
        std::vector<Eigen::Vector3f> points;
    };
    void keep(Time stamp, std::vector<Eigen::Vector3f> points);
    [[nodiscard]] bool isOwn(const Eigen::Vector3d& inBase) const;

    RobotBody m_body;
    std::deque<Chunk> m_chunks;  ///< by arrival
};

}  // namespace leitstand
