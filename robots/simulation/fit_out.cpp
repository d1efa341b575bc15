#include "robots/simulation/fit_out.h"

#include <utility>

#include "core/event/stream_role.h"
#include "robots/simulation/sensors/state/bumpers.h"
#include "robots/simulation/sensors/state/diagnostics.h"
#include "robots/simulation/sensors/state/inertial_unit.h"
#include "robots/simulation/sensors/state/wheel_odometry.h"

namespace leitstand::simulation {
namespace {

constexpr double BehindCamera = 0.03;  ///< from a camera back to where its unit's axes meet [m]

}  // namespace

FitOut::FitOut(World& world, int robot, const RobotDescription& description, std::uint64_t seed)
    : m_world(world), m_robot(robot), m_description(description), m_seed(seed) {
    m_baseFrame = description.baseFrame.empty() ? description.name + "/base_link" : description.baseFrame;
    m_prefix = m_baseFrame.substr(0, m_baseFrame.rfind('/') + 1);
    m_odomFrame = description.odomFrame.empty() ? m_prefix + "odom" : description.odomFrame;
}

Noise FitOut::noise(const std::string& name) const {
    return {m_seed, m_description.name + " " + name};
}

std::optional<SensorPlace> FitOut::place(StreamRole role, const std::string& key, const std::string& name,
                                         const Pose& usual) const {
    return placeOf(m_description, role, key, {name, m_prefix + name, usual});
}

void FitOut::fix(const std::string& frame, const Pose& inBase) {
    if (frame == m_baseFrame) return;
    m_fixed.push_back({{start(), m_baseFrame}, frame, inBase});
}

std::shared_ptr<MountedPanTilt> FitOut::addPanTilt(const std::string& name, const SensorPlace& camera) {
    Pose axes = Pose::Identity();
    axes.translation() = camera.inBase.translation() - BehindCamera * Eigen::Vector3d::UnitX();
    auto unit = std::make_shared<MountedPanTilt>(MountedPanTilt{
        name, m_prefix + name + "_pan", m_prefix + name + "_tilt", axes, PanTilt({}, start())});
    m_units.emplace(name, unit);
    return unit;
}

MountAt FitOut::mountOn(const std::shared_ptr<MountedPanTilt>& unit, const SensorPlace& place) {
    const Pose cameraOnUnit = unit->unitInBase.inverse() * place.inBase;
    m_fixed.push_back({{start(), unit->tiltFrame}, place.frame, cameraOnUnit});
    return [unit, cameraOnUnit](Time time) {
        return Pose(unit->unitInBase * unit->unit.platform(time) * cameraOnUnit);
    };
}

void FitOut::addReckoning() {
    InertialSettings inertial;
    inertial.frame = m_baseFrame;
    if (const auto imu = place(StreamRole::Imu, {}, "imu", Pose::Identity())) {
        inertial.sensor = imu->key;
        inertial.frame = imu->frame;
        inertial.unitInBase = imu->inBase;
        fix(imu->frame, imu->inBase);
    }
    auto unit = std::make_unique<InertialUnit>(inertial, noise("imu"), start());
    OdometrySettings odometry;
    odometry.odomFrame = m_odomFrame;
    odometry.baseFrame = m_baseFrame;
    auto wheels = std::make_unique<WheelOdometry>(odometry, *unit, start());
    add(std::move(unit));
    add(std::move(wheels));
}

std::unique_ptr<RobotHardware> FitOut::finish() {
    add(std::make_unique<Joints>(m_baseFrame, m_world.spec(m_robot).wheelRadius, m_units, m_fixed, start()));
    add(std::make_unique<Bumpers>(m_baseFrame));
    const StreamDescription* diagnostics = m_description.stream(StreamRole::Diagnostics);
    const bool named = diagnostics != nullptr && !diagnostics->hardwareId.empty();
    add(std::make_unique<Diagnostics>(named ? diagnostics->hardwareId : m_description.name, start()));
    return std::make_unique<SimulatedRobot>(m_world, m_robot, m_units, std::move(m_sensors));
}

}  // namespace leitstand::simulation
