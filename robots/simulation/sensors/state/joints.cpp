#include "robots/simulation/sensors/state/joints.h"

#include <algorithm>
#include <utility>

#include "core/event/motion_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double Rate = 20.0, MostRate = 50.0;  ///< [Hz]

}  // namespace

Joints::Joints(std::string baseFrame, double wheelRadius, PanTiltUnits units,
               std::vector<FrameTransform> fixed, Time start)
    : m_baseFrame(std::move(baseFrame)),
      m_wheelRadius(wheelRadius),
      m_units(std::move(units)),
      m_fixed(std::move(fixed)),
      m_schedule(Rate, start) {}

JointSample Joints::jointsOf(const BodyState& state, Time stamp) const {
    JointSample joints;
    joints.header = {stamp, m_baseFrame};
    const auto add = [&](const std::string& name, double position, double velocity) {
        joints.names.push_back(name);
        joints.positions.push_back(position);
        joints.velocities.push_back(velocity);
    };
    add("left_wheels", state.travelledLeft / m_wheelRadius, state.left / m_wheelRadius);
    add("right_wheels", state.travelledRight / m_wheelRadius, state.right / m_wheelRadius);
    for (const auto& [name, mounted] : m_units) {
        const PanTiltAngles angles = mounted->unit.at(stamp), speed = mounted->unit.velocity();
        add(name + "_pan", angles.pan, speed.pan);
        add(name + "_tilt", angles.tilt, speed.tilt);
    }
    return joints;
}

TransformsSample Joints::transforms(Time stamp) const {
    TransformsSample sample;
    for (const auto& [name, mounted] : m_units) {
        const PanTiltAngles angles = mounted->unit.at(stamp);
        const Pose pan = poseFrom(Eigen::Vector3d::Zero(), 0.0, 0.0, angles.pan);
        const Pose tilt = poseFrom(Eigen::Vector3d::Zero(), 0.0, angles.tilt, 0.0);
        sample.transforms.push_back({{stamp, m_baseFrame}, mounted->panFrame, mounted->unitInBase * pan});
        sample.transforms.push_back({{stamp, mounted->panFrame}, mounted->tiltFrame, tilt});
    }
    return sample;
}

void Joints::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    if (!m_fixedPublished && !m_fixed.empty()) {
        for (FrameTransform& transform : m_fixed) transform.header.stamp = world.now();
        samples.push_back({StreamRole::StaticTransforms, {}, TransformsSample{m_fixed}});
    }
    m_fixedPublished = true;
    while (const auto stamp = m_schedule.due(world.now())) {
        if (m_jointsEnabled) {
            samples.push_back({StreamRole::Joints, {}, jointsOf(world.state(robot), *stamp)});
        }
        if (m_transformsEnabled && !m_units.empty()) {
            samples.push_back({StreamRole::Transforms, {}, transforms(*stamp)});
        }
    }
}

bool Joints::configure(StreamRole role, const std::string&, const StreamSettings& settings) {
    if (role == StreamRole::StaticTransforms) {
        if (settings.enabled) m_fixedPublished = false;  // published again
        return true;
    }
    if (role == StreamRole::Transforms) {
        m_transformsEnabled = settings.enabled;
        return true;
    }
    if (role != StreamRole::Joints) return false;
    m_jointsEnabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, MostRate) : Rate);
    return true;
}

}  // namespace leitstand::simulation
