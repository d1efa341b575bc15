#include "transport/convert/encode.h"

#include <algorithm>

#include "transport/convert/detail/to_wire.h"

namespace leitstand {
namespace {

using namespace wire;  // packages of messages
using Encoder = Result<Payload> (*)(const Sample&);

/// Estimates the size of a message [B]: reserving it saves copies while the message is written.
template <class Message>
std::size_t bulk(const Message& message) {
    std::size_t size = 256;
    if constexpr (requires { message.data.size_bytes(); }) size += message.data.size_bytes();
    if constexpr (requires { message.points; }) size += message.points.size() * sizeof(float) * 2;
    if constexpr (requires { message.state.size_bytes(); }) size += message.state.size_bytes();
    return size;
}

template <class Kind, class Message>
Result<Payload> encodeAs(const Sample& sample) {
    const Kind* from = std::get_if<Kind>(&sample);
    if (from == nullptr) return Error{"it cannot say samples of this kind"};
    detail::Checks checks;
    detail::Buffer buffer;
    Message message;
    detail::toWire(*from, message, buffer, checks);
    if (!checks.ok()) return Error{checks.error()};
    CdrWriter out;
    out.reserve(bulk(message));
    encode(out, message);
    return Payload(std::make_shared<const std::vector<std::byte>>(std::move(out).finish()));
}

struct Entry {
    std::string_view type;
    Encoder encode;
    std::size_t kind;  // index in Sample
};

template <class Kind, std::size_t I = 0>
consteval std::size_t indexOf() {
    if constexpr (std::is_same_v<Kind, std::variant_alternative_t<I, Sample>>) {
        return I;
    } else {
        return indexOf<Kind, I + 1>();
    }
}

template <class Kind, class Message>
Entry entry() {
    return {Message::RosName, &encodeAs<Kind, Message>, indexOf<Kind>()};
}

/// When a kind has several types, the first one holds everything.
const std::vector<Entry>& entries() {
    static const std::vector<Entry> all = {
        entry<CloudSample, sensor_msgs::PointCloud2>(),
        entry<RangesSample, sensor_msgs::LaserScan>(),
        entry<OdometrySample, nav_msgs::Odometry>(),
        entry<ImuSample, sensor_msgs::Imu>(),
        entry<JointSample, sensor_msgs::JointState>(),
        entry<TransformsSample, tf2_msgs::TFMessage>(),
        entry<PictureSample, sensor_msgs::Image>(),
        entry<PictureSample, sensor_msgs::CompressedImage>(),
        entry<CameraInfoSample, sensor_msgs::CameraInfo>(),
        entry<GasSample, leitstand_msgs::GasConcentration>(),
        entry<GasSample, std_msgs::Float32>(),
        entry<BatterySample, sensor_msgs::BatteryState>(),
        entry<DiagnosticsSample, diagnostic_msgs::DiagnosticArray>(),
        entry<ModeSample, leitstand_msgs::Mode>(),
        entry<BumpSample, leitstand_msgs::Bumps>(),
        entry<SightingSample, leitstand_msgs::Sightings>(),
        entry<StopStateSample, leitstand_msgs::StopState>(),
        entry<PongSample, leitstand_msgs::Pong>(),
        entry<TwistSample, geometry_msgs::Twist>(),
        entry<TwistSample, geometry_msgs::TwistStamped>(),
        entry<StopCommandSample, leitstand_msgs::StopCommand>(),
        entry<ModeCommandSample, leitstand_msgs::ModeCommand>(),
        entry<PoseSample, geometry_msgs::PoseStamped>(),
        entry<StreamCommandSample, leitstand_msgs::StreamCommand>(),
        entry<PingSample, leitstand_msgs::Ping>(),
        entry<GrantSample, leitstand_msgs::Grant>(),
        entry<FindSample, leitstand_msgs::Victim>(),
        entry<CandidateSample, leitstand_msgs::Candidate>(),
        entry<KeyScanSample, leitstand_msgs::KeyScan>(),
        entry<ScanPosesSample, leitstand_msgs::ScanPoses>(),
        entry<ScanLinksSample, leitstand_msgs::ScanLinks>(),
        entry<ScanBodiesSample, leitstand_msgs::ScanBodies>(),
        entry<MapCropSample, leitstand_msgs::MapCrop>(),
        entry<RobotPlaceSample, leitstand_msgs::RobotPlace>(),
        entry<ClockSample, leitstand_msgs::MissionClock>(),
        entry<MissionInfoSample, leitstand_msgs::MissionInfo>(),
        entry<ClockOffsetSample, leitstand_msgs::ClockOffset>(),
        entry<UndoSample, leitstand_msgs::Undo>(),
        entry<CheckpointSample, leitstand_msgs::Checkpoint>(),
        entry<NoteSample, leitstand_msgs::Note>(),
        entry<SessionSample, leitstand_msgs::Session>(),
        entry<AlarmSample, leitstand_msgs::Alarm>(),
    };
    return all;
}

}  // namespace

Result<Payload> encode(const Sample& sample, std::string_view type) {
    const auto& all = entries();
    const auto ofType = [&](const Entry& entry) { return entry.type == type; };
    const auto found = std::find_if(all.begin(), all.end(), ofType);
    if (found == all.end()) return Error{fmt::format("{}: Leitstand sends no such messages", type)};
    auto payload = found->encode(sample);
    if (!payload) return Error{fmt::format("{}: {}", type, payload.error().text)};
    return payload;
}

std::string_view typeOf(const Sample& sample) {
    if (const auto* twist = std::get_if<TwistSample>(&sample); twist != nullptr && twist->stamp) {
        return geometry_msgs::TwistStamped::RosName;
    }
    if (const auto* picture = std::get_if<PictureSample>(&sample);
        picture != nullptr && picture->compressed) {
        return sensor_msgs::CompressedImage::RosName;
    }
    const auto& all = entries();
    return std::find_if(all.begin(), all.end(),
                        [&](const Entry& entry) { return entry.kind == sample.index(); })
        ->type;
}

std::optional<Time> commandStamp(StampSource source, Time now, std::chrono::nanoseconds ahead) {
    switch (source) {
        case StampSource::Robot:
            return now + ahead;
        case StampSource::Zero:
            return std::nullopt;
        case StampSource::Station:
            return now;
    }
    return std::nullopt;
}

}  // namespace leitstand
