#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/event/motion_samples.h"
#include "robots/simulation/sensors/camera/camera.h"
#include "robots/simulation/sensors/noise.h"
#include "robots/simulation/sensors/sensor_place.h"
#include "robots/simulation/simulated_robot.h"

namespace leitstand::simulation {

/// Equips a robot in a world with the sensors of its description, and collects its fixed frames.
class FitOut {
public:
    FitOut(World& world, int robot, const RobotDescription& description, std::uint64_t seed);

    /// Returns the random numbers for the noise of the sensor called @p name.
    [[nodiscard]] Noise noise(const std::string& name) const;
    /// Returns where the sensor of the stream with @p role (and @p key, if given) is mounted. What the
    /// description leaves out is taken from @p name and @p usual (pose in base_link). Empty: the robot has no
    /// such sensor.
    [[nodiscard]] std::optional<SensorPlace> place(StreamRole role, const std::string& key,
                                                   const std::string& name, const Pose& usual) const;
    /// Adds @p frame, at @p inBase in base_link, to the static transforms (tf_static).
    void fix(const std::string& frame, const Pose& inBase);
    /// Adds a pan-tilt unit behind the camera at @p camera.
    std::shared_ptr<MountedPanTilt> addPanTilt(const std::string& name, const SensorPlace& camera);
    /// Mounts the camera at @p place on @p unit. Returns the camera's pose in base_link over time.
    [[nodiscard]] MountAt mountOn(const std::shared_ptr<MountedPanTilt>& unit, const SensorPlace& place);
    void add(std::unique_ptr<Sensor> sensor) { m_sensors.push_back(std::move(sensor)); }

    /// Adds the inertial unit and the odometry.
    void addReckoning();
    /// Adds what every robot has (joints, bumpers, diagnostics) and returns the robot's hardware.
    [[nodiscard]] std::unique_ptr<RobotHardware> finish();

    [[nodiscard]] Time start() const { return m_world.now(); }
    [[nodiscard]] const std::string& baseFrame() const { return m_baseFrame; }

private:
    World& m_world;
    int m_robot;
    const RobotDescription& m_description;
    std::uint64_t m_seed;
    std::string m_prefix;  ///< prefix of frame names, the same as that of base_link: "kurt3d/" or empty
    std::string m_baseFrame, m_odomFrame;
    PanTiltUnits m_units;
    std::vector<FrameTransform> m_fixed;
    std::vector<std::unique_ptr<Sensor>> m_sensors;
};

}  // namespace leitstand::simulation
