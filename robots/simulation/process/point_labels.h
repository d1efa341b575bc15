#pragma once

#include "core/base/pose.h"
#include "core/event/cloud_sample.h"
#include "core/event/picture_samples.h"
#include "core/robot/robot_description.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// True labels of what a robot's 3D scanner measured: of the surface that stands where a point was measured.
class PointLabels {
public:
    /// @p robot: number in its world.
    PointLabels(const RobotDescription& description, int robot);

    /// A grey picture with a pixel for each point of @p cloud, in its rows and columns, with its header: the
    /// number of its Label. Points without echo and those between surfaces (mixed pixels) are Unlabelled.
    /// @p cloud was measured within the last 5 s.
    [[nodiscard]] PictureSample of(const CloudSample& cloud, const World& world) const;

private:
    Pose m_mountInBase;
    int m_robot;
};

}  // namespace leitstand::simulation
