#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/time.h"
#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct TwistSample;

/// Who receives a sample: the robot's own drivers and the network (Everywhere), only the drivers (OnBoard),
/// or only the network (Sent). So drivers get what they need, even when a stream is sent less often.
enum class Reach : std::uint8_t { Everywhere, OnBoard, Sent };

/// One sample of a sensor on board.
struct HardwareSample {
    StreamRole role = StreamRole::Odometry;
    std::string sensor;  ///< key of RobotDescription::sensors, "left"; empty for what belongs to the robot
    Sample sample;       ///< frames as in the robot's description; stamps on the robot's clock
    Reach reach = Reach::Everywhere;
};

/// How the two sides of a drive turn, by their encoders.
struct TrackState {
    double left = 0.0, right = 0.0;                ///< speed of wheels or chains, slip not seen [m/s]
    double leftCurrent = 0.0, rightCurrent = 0.0;  ///< of the motors [A]
};

/// How a stream is sent. Lasers go on for the robot's own drivers, whatever is sent (Reach).
struct StreamSettings {
    bool enabled = true;
    double rate = 0.0;  ///< [Hz]; 0: the sensor's own
    int quality = 0;    ///< of JPEG, 1 to 100; 0: the sensor's own
    int maxWidth = 0;   ///< [px]; 0: the sensor's own
};

/// What an agent needs from the robot that it drives. Real and simulated robots look the same to it. One
/// thread.
class RobotHardware {
public:
    virtual ~RobotHardware() = default;

    [[nodiscard]] virtual Time now() const = 0;  ///< robot's clock
    /// Returns samples that became ready since the last call, in the order of their stamps.
    [[nodiscard]] virtual std::vector<HardwareSample> take() = 0;
    [[nodiscard]] virtual TrackState tracks() const = 0;

    /// Sets voltages of the motors, -1 to 1 of the full battery's; they hold until the next call.
    virtual void setMotors(double left, double right) = 0;
    virtual void setBrake(bool on) = 0;  ///< holds the robot, also on ramps
    /// Turns a pan-tilt unit ("left", "right") as fast as it can, within its limits [rad].
    virtual void setPanTilt(const std::string& unit, double pan, double tilt) = 0;
    virtual void setStream(StreamRole role, const std::string& sensor, const StreamSettings& settings) = 0;
    /// Returns the radio remote's command; empty while it is not in use (or there is none).
    [[nodiscard]] virtual std::optional<TwistSample> remote() const = 0;
};

}  // namespace leitstand
