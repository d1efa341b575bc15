#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "robots/simulation/sensors/camera/camera.h"
#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/sensor_place.h"
#include "robots/simulation/simulated_robot.h"

namespace leitstand::simulation {

/// Puts sensors on a robot of a world, as its description says, and keeps its frames.
class FitOut {
public:
    FitOut(World& world, int robot, const RobotDescription& description, std::uint64_t seed);

    /// Noise of its own for the sensor called @p name.
    [[nodiscard]] Noise noise(const std::string& name) const;
    /// Where the sensor of the stream of @p role (and @p key, when given) sits. @p name and @p usual: what it
    /// is called and where it sits when nobody says. Empty: the robot has none.
    [[nodiscard]] std::optional<SensorPlace> place(StreamRole role, const std::string& key,
                                                   const std::string& name, const Pose& usual) const;
    /// Tells by tf_static that @p frame sits there in base_link.
    void fix(const std::string& frame, const Pose& inBase);
    /// A pan-tilt unit behind a camera at @p camera.
    std::shared_ptr<MountedPanTilt> addPanTilt(const std::string& name, const SensorPlace& camera);
    /// Puts the camera that sits at @p place onto @p unit. Returns where it is over time.
    [[nodiscard]] MountAt mountOn(const std::shared_ptr<MountedPanTilt>& unit, const SensorPlace& place);
    void add(std::unique_ptr<Sensor> sensor) { m_sensors.push_back(std::move(sensor)); }

    /// Inertial unit and odometry.
    void addReckoning();
    /// Adds what every robot has (joints, bumpers, diagnostics) and returns the whole.
    [[nodiscard]] std::unique_ptr<RobotHardware> finish();

    [[nodiscard]] Time start() const { return m_world.now(); }
    [[nodiscard]] const std::string& baseFrame() const { return m_baseFrame; }

private:
    World& m_world;
    int m_robot;
    const RobotDescription& m_description;
    std::uint64_t m_seed;
    std::string m_prefix;  ///< of names of frames: "kurt3d/" or nothing, as base_link's
    std::string m_baseFrame, m_odomFrame;
    PanTiltUnits m_units;
    std::vector<FrameTransform> m_fixed;
    std::vector<std::unique_ptr<Sensor>> m_sensors;
};

}  // namespace leitstand::simulation
