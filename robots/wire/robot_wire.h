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

/// A command or grant that was received for a robot.
struct ReceivedCommand {
    StreamRole role = StreamRole::DriveCommand;  ///< role of the command stream; not used for grants
    bool grant = false;                          ///< whether the sample is a GrantSample
    Sample sample;
    Sender from;             ///< process that sent it
    Time received;           ///< when all of it had been received, this computer's clock
    std::string group = {};  ///< of a joint command: the group of joints
};

struct RobotWireCounts {
    std::uint64_t accepted = 0;
    std::uint64_t broken = 0;   ///< number of commands that could not be read
    std::uint64_t dropped = 0;  ///< number of commands that were not taken in time; stops are never dropped
    std::uint64_t published = 0;
    std::uint64_t unpublished = 0;  ///< number of samples that could not be encoded or written
};

/// A robot's network connection: receives commands and grants, and publishes samples with the topics, types
/// and QoS of its description. Any thread.
class RobotWire {
public:
    /// Whether the robot obeys grants, which say who may drive it; stock robots do not.
    enum class Grants : std::uint8_t { Obeyed, Unknown };

    /// Errors name the topic.
    [[nodiscard]] static Result<std::unique_ptr<RobotWire>> create(Node& node, const RobotDescription& robot,
                                                                   Grants grants = Grants::Obeyed);
    ~RobotWire();
    RobotWire(const RobotWire&) = delete;
    RobotWire& operator=(const RobotWire&) = delete;

    /// Returns the commands received since the last call, in order. A drive command that cannot be read
    /// becomes NaN, which stops the robot.
    [[nodiscard]] std::vector<ReceivedCommand> take();
    /// Publishes @p sample on all streams with its role and sensor; does nothing when the robot has none.
    /// Never waits. On streams of sensor_msgs/msg/Image, compressed pictures are sent raw, on those of videos
    /// as such, if somebody reads them.
    void publish(const HardwareSample& sample);
    [[nodiscard]] RobotWireCounts counts() const;

private:
    struct State;
    explicit RobotWire(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
