#include "transport/convert/decode.h"

#include <algorithm>
#include <initializer_list>

#include "core/event/station_topics.h"
#include "core/robot/frame_names.h"
#include "transport/convert/detail/from_wire.h"

namespace leitstand {
namespace {

using namespace wire;  // packages of messages
using Role = StreamRole;
using Decoder = Result<Sample> (*)(const RawEvent&, const StreamDescription*);

template <class Message>
Result<Sample> decodeAs(const RawEvent& event, const StreamDescription* stream) {
    CdrReader in(*event.cdr);
    Message message;
    decode(in, message);
    if (const auto end = in.finish(); !end) return end.error();
    detail::Checks checks;
    auto sample = detail::fromWire(message, detail::Source{event.cdr, stream}, checks);
    if (!checks.ok()) return Error{checks.error()};
    return Sample(std::move(sample));
}

/// A type of message and the streams of robots on which it is understood; none: the stations' own.
struct Entry {
    std::string_view type;
    Decoder decode;
    std::vector<Role> roles;
};

template <class Message>
Entry entry(std::vector<Role> roles = {}) {
    return {Message::RosName, &decodeAs<Message>, std::move(roles)};
}

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = {
        entry<sensor_msgs::PointCloud2>({Role::Points}),
        entry<sensor_msgs::LaserScan>({Role::Ranges}),
        entry<nav_msgs::Odometry>({Role::Odometry}),
        entry<sensor_msgs::Imu>({Role::Imu}),
        entry<sensor_msgs::JointState>({Role::Joints, Role::TrackCommand, Role::PanTiltCommand}),
        entry<tf2_msgs::TFMessage>({Role::Transforms, Role::StaticTransforms}),
        entry<sensor_msgs::Image>({Role::Picture, Role::Thermal}),
        entry<sensor_msgs::CompressedImage>({Role::Picture, Role::Thermal}),
        entry<sensor_msgs::CameraInfo>({Role::CameraInfo}),
        entry<leitstand_msgs::GasConcentration>({Role::Gas}),
        entry<std_msgs::Float32>({Role::Gas}),
        entry<std_msgs::Float64>({Role::Gas}),
        entry<sensor_msgs::BatteryState>({Role::Battery}),
        entry<diagnostic_msgs::DiagnosticArray>({Role::Diagnostics}),
        entry<leitstand_msgs::Mode>({Role::Mode}),
        entry<leitstand_msgs::Bumps>({Role::Bumps}),
        entry<leitstand_msgs::Sightings>({Role::Sightings}),
        entry<leitstand_msgs::StopState>({Role::StopState}),
        entry<leitstand_msgs::Pong>({Role::Pong}),
        entry<geometry_msgs::Twist>({Role::DriveCommand}),
        entry<geometry_msgs::TwistStamped>({Role::DriveCommand}),
        entry<leitstand_msgs::StopCommand>({Role::StopCommand}),
        entry<leitstand_msgs::ModeCommand>({Role::ModeCommand}),
        entry<geometry_msgs::PoseStamped>({Role::GoalPose}),
        entry<leitstand_msgs::StreamCommand>({Role::StreamCommand}),
        entry<leitstand_msgs::Ping>({Role::Ping}),
        entry<leitstand_msgs::Grant>(),
        entry<leitstand_msgs::Victim>(),
        entry<leitstand_msgs::Candidate>(),
        entry<leitstand_msgs::KeyScan>(),
        entry<leitstand_msgs::ScanPoses>(),
        entry<leitstand_msgs::ScanLinks>(),
        entry<leitstand_msgs::ScanBodies>(),
        entry<leitstand_msgs::MapCrop>(),
        entry<leitstand_msgs::RobotPlace>(),
        entry<leitstand_msgs::MissionClock>(),
        entry<leitstand_msgs::MissionInfo>(),
        entry<leitstand_msgs::ClockOffset>(),
        entry<leitstand_msgs::Undo>(),
        entry<leitstand_msgs::Checkpoint>(),
        entry<leitstand_msgs::Note>(),
        entry<leitstand_msgs::Session>(),
        entry<leitstand_msgs::Alarm>(),
    };
    return all;
}

bool serves(const Entry& entry, const StreamDescription* stream) {
    if (stream == nullptr) return entry.roles.empty();
    return std::find(entry.roles.begin(), entry.roles.end(), stream->role) != entry.roles.end();
}

/// The types that @p stream may have, for a message.
std::string expectedTypes(const StreamDescription* stream) {
    std::string text;
    for (const Entry& entry : entries()) {
        if (!serves(entry, stream)) continue;
        text += (text.empty() ? "" : ", ") + std::string(entry.type);
    }
    return text;
}

Result<Sample> decodeFor(const RawEvent& event, const StreamDescription* stream) {
    const auto fail = [&](const std::string& text) {
        return Error{fmt::format("{}: {}: {}", event.topic, event.type, text)};
    };
    if (event.cdr == nullptr) return fail("there are no bytes");
    const auto& all = entries();
    const auto found = std::find_if(all.begin(), all.end(), [&](const Entry& entry) {
        return entry.type == event.type && serves(entry, stream);
    });
    if (found == all.end()) {
        return fail(fmt::format("expected {} for {}", expectedTypes(stream),
                                stream == nullptr ? "a station's own topic" : toString(stream->role)));
    }
    auto sample = found->decode(event, stream);
    if (!sample) return fail(sample.error().text);
    return sample;
}

/// Names the frames of @p sample after its robot.
template <class Kind>
void nameFrames(Kind& sample, const RobotDescription& robot) {
    if constexpr (requires { sample.header.frame; }) {
        sample.header.frame = frameName(robot, sample.header.frame);
    }
    if constexpr (requires { sample.childFrame; }) sample.childFrame = frameName(robot, sample.childFrame);
}

void nameFrames(TransformsSample& sample, const RobotDescription& robot) {
    std::erase_if(sample.transforms, [&](const FrameTransform& transform) {
        return !isOwnTransform(robot, transform.header.frame, transform.childFrame);
    });
    for (FrameTransform& transform : sample.transforms) nameFrames(transform, robot);
}

}  // namespace

std::vector<std::string_view> typesFor(StreamRole role) {
    StreamDescription stream;
    stream.role = role;
    std::vector<std::string_view> types;
    for (const Entry& entry : entries()) {
        if (serves(entry, &stream)) types.push_back(entry.type);
    }
    return types;
}

Result<Sample> decode(const RawEvent& event, const StreamDescription& stream) {
    return decodeFor(event, &stream);
}

Result<Event> decodeEvent(const RawEvent& event, const RobotDescription& robot,
                          const StreamDescription& stream) {
    auto sample = decodeFor(event, &stream);
    if (!sample) return sample.error();
    Sample content = std::move(sample).value();
    std::visit([&](auto& kind) { nameFrames(kind, robot); }, content);
    return Event{event.sequence, event.received, robot.name,        event.topic,
                 stream.role,    stream.sensor,  std::move(content)};
}

Result<Event> decodeStationEvent(const RawEvent& event) {
    auto sample = decodeFor(event, nullptr);
    if (!sample) return sample.error();
    return Event{event.sequence,           event.received, {}, event.topic, std::nullopt, {},
                 std::move(sample).value()};
}

}  // namespace leitstand
