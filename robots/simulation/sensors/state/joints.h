#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/event/motion_samples.h"
#include "robots/simulation/sensors/pan_tilt.h"
#include "robots/simulation/sensors/schedule.h"
#include "robots/simulation/sensors/sensor.h"

namespace leitstand::simulation {

/// A pan-tilt unit on a robot, with its frames: NAME_pan is in base_link, NAME_tilt is in NAME_pan.
struct MountedPanTilt {
    std::string name;  ///< "left"
    std::string panFrame, tiltFrame;
    Pose unitInBase = Pose::Identity();  ///< where its axes meet when it is not turned
    PanTilt unit;
};
using PanTiltUnits = std::map<std::string, std::shared_ptr<MountedPanTilt>>;

/// Publishes the angles of wheels and pan-tilt units as joint states, the transforms of the units, and once
/// the static transforms.
class Joints final : public Sensor {
public:
    Joints(std::string baseFrame, double wheelRadius, PanTiltUnits units, std::vector<FrameTransform> fixed,
           Time start);

    void run(const World& world, int robot, std::vector<HardwareSample>& samples) override;
    bool configure(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;

private:
    [[nodiscard]] JointSample jointsOf(const BodyState& state, Time stamp) const;
    [[nodiscard]] TransformsSample transforms(Time stamp) const;

    std::string m_baseFrame;
    double m_wheelRadius;
    PanTiltUnits m_units;
    std::vector<FrameTransform> m_fixed;
    Schedule m_schedule;
    bool m_jointsEnabled = true, m_transformsEnabled = true, m_fixedPublished = false;
};

}  // namespace leitstand::simulation
