#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/result.h"
#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "core/robot/control/grants.h"
#include "core/robot/robot_description.h"
#include "robots/hardware/robot_hardware.h"
#include "transport/dds/node.h"

namespace leitstand {

/// A command or grant that came over the wire for a robot.
struct ReceivedCommand {
    StreamRole role = StreamRole::DriveCommand;  ///< of the command stream; unused for grants
    bool grant = false;                          ///< sample is a GrantSample
    Sample sample;
    Sender from;    ///< the process that sent it
    Time received;  ///< when it was complete here, this computer's clock
};

struct RobotWireCounts {
    std::uint64_t accepted = 0;
    std::uint64_t broken = 0;   ///< could not be read
    std::uint64_t dropped = 0;  ///< commands that nobody took in time; stops are never dropped
    std::uint64_t published = 0;
    std::uint64_t unpublished = 0;  ///< could not be encoded or written
};

/// A robot's end of the wire: receives commands and grants, publishes samples with the topics, types and QoS
/// of its description. Any thread.
class RobotWire {
public:
    /// Whether the robot listens to who may drive it; stock robots do not.
    enum class Grants : std::uint8_t { Obeyed, Unknown };

    /// Errors name the topic.
    [[nodiscard]] static Result<std::unique_ptr<RobotWire>> create(Node& node, const RobotDescription& robot,
                                                                   Grants grants = Grants::Obeyed);
    ~RobotWire();
    RobotWire(const RobotWire&) = delete;
    RobotWire& operator=(const RobotWire&) = delete;

    /// Returns what came since the last call, in order. A drive command that cannot be read becomes NaN,
    /// which stops the robot.
    [[nodiscard]] std::vector<ReceivedCommand> take();
    /// Publishes @p sample on all streams of its role and sensor; does nothing when the robot has none. Never
    /// waits. Compressed pictures become raw ones on streams of sensor_msgs/msg/Image, while somebody
    /// listens.
    void publish(const HardwareSample& sample);
    [[nodiscard]] RobotWireCounts counts() const;

private:
    struct State;
    explicit RobotWire(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
