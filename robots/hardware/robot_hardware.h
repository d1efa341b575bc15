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
/// or only the network (Sent). So drivers get all that they need, even if a stream is sent less often.
enum class Reach : std::uint8_t { Everywhere, OnBoard, Sent };

/// One sample of a sensor on board.
struct HardwareSample {
    StreamRole role = StreamRole::Odometry;
    /// Key of RobotDescription::sensors, "left"; empty: it belongs to the robot as a whole.
    std::string sensor;
    Sample sample;  ///< frames as in the robot's description; stamps on the robot's clock
    Reach reach = Reach::Everywhere;
};

/// How the two sides of a drive move, as their encoders measure it.
struct TrackState {
    double left = 0.0, right = 0.0;                ///< speed of wheels or chains; slip is not measured [m/s]
    double leftCurrent = 0.0, rightCurrent = 0.0;  ///< current of the motors [A]
};

/// How a stream is sent. The robot's own drivers always receive its lasers at full rate (Reach).
struct StreamSettings {
    bool enabled = true;
    double rate = 0.0;  ///< rate [Hz]; 0: the sensor's own
    int quality = 0;    ///< quality of JPEG, 1 to 100; 0: the sensor's own
    int maxWidth = 0;   ///< largest width of pictures [px]; 0: the sensor's own
};

/// What an agent needs from the robot that it drives. Real and simulated robots have the same interface. One
/// thread.
class RobotHardware {
public:
    virtual ~RobotHardware() = default;

    [[nodiscard]] virtual Time now() const = 0;  ///< robot's clock
    /// Returns samples that have become ready since the last call, in the order of their stamps.
    [[nodiscard]] virtual std::vector<HardwareSample> take() = 0;
    [[nodiscard]] virtual TrackState tracks() const = 0;

    /// Sets the voltages of the motors, as shares of the full battery's: -1 to 1. They remain until the next
    /// call.
    virtual void setMotors(double left, double right) = 0;
    virtual void setBrake(bool on) = 0;  ///< the brake holds the robot, also on ramps
    /// Turns a pan-tilt unit ("left", "right") as fast as it can, within its limits [rad].
    virtual void setPanTilt(const std::string& unit, double pan, double tilt) = 0;
    virtual void setStream(StreamRole role, const std::string& sensor, const StreamSettings& settings) = 0;
    /// Returns the radio remote's command. Empty while it is not in use, or if there is none.
    [[nodiscard]] virtual std::optional<TwistSample> remote() const = 0;
};

}  // namespace leitstand
