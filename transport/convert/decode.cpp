#include "transport/convert/decode.h"

#include <algorithm>
#include <initializer_list>

#include "core/event/station_topics.h"
#include "core/robot/frame_names.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/detail/from_wire.h"

namespace leitstand {
namespace {

using namespace wire;  // packages of messages
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

/// A type of message. The table of streams lists which streams of robots may have it.
struct Entry {
    std::string_view type;
    Decoder decode;
    bool ofStations = false;  ///< belongs to the stations' own topics
};

template <class Message>
Entry entry() {
    return {Message::RosName, &decodeAs<Message>};
}
template <class Message>
Entry stationEntry() {
    return {Message::RosName, &decodeAs<Message>, true};
}

const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = {
        entry<sensor_msgs::PointCloud2>(),
        entry<sensor_msgs::LaserScan>(),
        entry<nav_msgs::Odometry>(),
        entry<sensor_msgs::Imu>(),
        entry<sensor_msgs::JointState>(),
        entry<tf2_msgs::TFMessage>(),
        entry<sensor_msgs::Image>(),
        entry<sensor_msgs::CompressedImage>(),
        entry<sensor_msgs::CameraInfo>(),
        entry<leitstand_msgs::GasConcentration>(),
        entry<std_msgs::Float32>(),
        entry<std_msgs::Float64>(),
        entry<sensor_msgs::BatteryState>(),
        entry<diagnostic_msgs::DiagnosticArray>(),
        entry<leitstand_msgs::Mode>(),
        entry<leitstand_msgs::Bumps>(),
        entry<leitstand_msgs::Sightings>(),
        entry<leitstand_msgs::StopState>(),
        entry<leitstand_msgs::Pong>(),
        entry<geometry_msgs::Twist>(),
        entry<geometry_msgs::TwistStamped>(),
        entry<leitstand_msgs::StopCommand>(),
        entry<leitstand_msgs::ModeCommand>(),
        entry<geometry_msgs::PoseStamped>(),
        entry<leitstand_msgs::StreamCommand>(),
        entry<leitstand_msgs::Ping>(),
        stationEntry<leitstand_msgs::Grant>(),
        stationEntry<leitstand_msgs::Victim>(),
        stationEntry<leitstand_msgs::Candidate>(),
        stationEntry<leitstand_msgs::KeyScan>(),
        stationEntry<leitstand_msgs::ScanPoses>(),
        stationEntry<leitstand_msgs::ScanLinks>(),
        stationEntry<leitstand_msgs::ScanBodies>(),
        stationEntry<leitstand_msgs::MapCrop>(),
        stationEntry<leitstand_msgs::RobotPlace>(),
        stationEntry<leitstand_msgs::MissionClock>(),
        stationEntry<leitstand_msgs::MissionInfo>(),
        stationEntry<leitstand_msgs::ClockOffset>(),
        stationEntry<leitstand_msgs::Undo>(),
        stationEntry<leitstand_msgs::Checkpoint>(),
        stationEntry<leitstand_msgs::Note>(),
        stationEntry<leitstand_msgs::Session>(),
        stationEntry<leitstand_msgs::Alarm>(),
    };
    return all;
}

bool serves(const Entry& entry, const StreamDescription* stream) {
    if (stream == nullptr || entry.ofStations) return stream == nullptr && entry.ofStations;
    const auto types = typesOf(stream->role);
    return std::find(types.begin(), types.end(), entry.type) != types.end();
}

/// Returns the types that @p stream may have, as text for an error.
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
