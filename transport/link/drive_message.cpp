#include "transport/link/drive_message.h"

#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/event/motion_samples.h"
#include "core/event/sample.h"
#include "core/event/stream_role.h"
#include "transport/convert/encode.h"

namespace leitstand {
namespace {

Sample sampleOf(const DriveMessage& message, const DriveVelocity& velocity,
                std::chrono::nanoseconds clockAhead) {
    const std::optional<Time> stamp =
        commandStamp(message.stream.stamp, std::chrono::system_clock::now(), clockAhead);
    if (message.stream.role == StreamRole::TrackCommand) {
        const auto [left, right] = tracksOf(velocity, message.trackDistance);
        TrackCommand command;
        command.header = {stamp.value_or(Time{}), message.frame};
        command.names = {message.leftTrack, message.rightTrack};
        command.velocities = {left, right};
        return command;
    }
    TwistSample command;
    command.stamp = stamp;
    command.frame = message.frame;
    command.linear = {velocity.forward, velocity.left, 0.0};
    command.angular = {0.0, 0.0, velocity.turn};
    return command;
}

}  // namespace

Result<DriveMessage> driveMessageFor(const RobotDescription& robot) {
    const StreamDescription* stream = robot.stream(StreamRole::DriveCommand);
    if (stream == nullptr) stream = robot.stream(StreamRole::TrackCommand);
    if (stream == nullptr) {
        return Error{
            fmt::format("{}: expected a stream drive_command or track_command, found neither", robot.name)};
    }
    if (stream->role == StreamRole::TrackCommand && trackDistance(robot) <= 0.0) {
        return Error{
            fmt::format("{}: track_command: expected a footprint that is as wide as its tracks", robot.name)};
    }
    return DriveMessage{.stream = *stream, .frame = robot.baseFrame, .trackDistance = trackDistance(robot)};
}

Result<Payload> DriveMessage::encoded(const DriveVelocity& velocity,
                                      std::chrono::nanoseconds clockAhead) const {
    return encode(sampleOf(*this, velocity, clockAhead), stream.type);
}

}  // namespace leitstand
