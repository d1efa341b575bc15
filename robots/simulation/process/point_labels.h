#pragma once

#include "core/base/pose.h"
#include "core/event/cloud_sample.h"
#include "core/event/picture_samples.h"
#include "core/robot/robot_description.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// True labels of a robot's 3D scans: each point gets the label of the surface on which it was measured.
class PointLabels {
public:
    /// @p robot: number of the robot in the world.
    PointLabels(const RobotDescription& description, int robot);

    /// Returns a grey picture with the header, rows and columns of @p cloud. Each pixel is the number of its
    /// point's Label. Points without echo and points between surfaces (mixed pixels) are Unlabelled. @p cloud
    /// must be at most 5 s old.
    [[nodiscard]] PictureSample of(const CloudSample& cloud, const World& world) const;

private:
    Pose m_mountInBase;
    int m_robot;
};

}  // namespace leitstand::simulation
