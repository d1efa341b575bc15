#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/perception/pixel_ray.h"
#include "core/robot/samples/cloud_sample.h"

namespace leitstand {

/// Where a ray meets what a scanner saw.
struct RayHit {
    double range = 0.0;    ///< from the ray's origin [m]
    double scatter = 0.0;  ///< deviation of the ranges of the points that it is of [m]
    int points = 0;
};

/// What a robot's scanners saw in the last seconds, in the odometry's frame: rays of its cameras are cut with
/// it. One thread.
class SeenPoints {
public:
    using PoseAt = std::function<std::optional<Pose>(Time)>;
    static constexpr std::chrono::milliseconds Memory{4000};

    /// Points on @p body, the robot's own, are left out.
    explicit SeenPoints(RobotBody body = {});

    /// @p baseInOdom tells where the robot was; points of times that it does not know are left out.
    void add(const CloudSample& slice, const Pose& sensorInBase, const PoseAt& baseInOdom);
    void add(const RangesSample& turn, const Pose& sensorInBase, const PoseAt& baseInOdom);
    void clear() { m_chunks.clear(); }

    /// Where @p ray (odometry's frame) meets a surface: of the points within @p halfAngle [rad] about it,
    /// those of the surface that most of them are on, the middle ones first. The cone is widened up to twice
    /// where it holds too few. Empty where nothing was seen nearer than @p farthest [m].
    [[nodiscard]] std::optional<RayHit> meet(const Ray& ray, double halfAngle, double farthest = 9.0) const;

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
