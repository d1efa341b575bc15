#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/event/motion_samples.h"
#include "robots/hardware/robot_hardware.h"
#include "robots/simulation/sensors/sensor.h"
#include "robots/simulation/sensors/state/joints.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// The hardware of a simulated robot: its sensors, pan-tilt units, motors and remote.
class SimulatedRobot final : public RobotHardware {
public:
    /// @p world must outlive this object. @p sensors run in their order.
    SimulatedRobot(World& world, int robot, PanTiltUnits units, std::vector<std::unique_ptr<Sensor>> sensors);

    [[nodiscard]] Time now() const override;
    [[nodiscard]] std::vector<HardwareSample> take() override;
    [[nodiscard]] TrackState tracks() const override;
    void setMotors(double left, double right) override;
    void setBrake(bool on) override;
    void setPanTilt(const std::string& unit, double pan, double tilt) override;
    void setStream(StreamRole role, const std::string& sensor, const StreamSettings& settings) override;
    [[nodiscard]] std::optional<TwistSample> remote() const override { return m_remote; }

    /// Sets what the radio remote commands; empty: nobody uses it.
    void setRemote(const std::optional<TwistSample>& remote) { m_remote = remote; }

private:
    World& m_world;
    int m_robot;
    PanTiltUnits m_units;
    std::vector<std::unique_ptr<Sensor>> m_sensors;
    std::optional<TwistSample> m_remote;
};

}  // namespace leitstand::simulation
