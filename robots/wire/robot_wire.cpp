#include "robots/wire/robot_wire.h"

#include <algorithm>
#include <limits>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "core/event/command_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/sample.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/video/video_bitstream.h"
#include "core/perception/pictures/video/video_packet.h"
#include "core/robot/streams/stream_table.h"
#include "robots/wire/depth_file_writing.h"
#include "robots/wire/raw_picture.h"
#include "robots/wire/video_encoder.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"
#include "transport/link/grant_keeper.h"
#include "transport/link/grant_sender.h"

namespace leitstand {
namespace {

constexpr std::size_t MostWaiting = 1000;
constexpr const char* RawPictures = "sensor_msgs/msg/Image";
constexpr const char* CompressedPictures = "sensor_msgs/msg/CompressedImage";

Flow flowOf(StreamRole role) {
    if (role == StreamRole::StopState || role == StreamRole::Mode || role == StreamRole::Pong)
        return Flow::Immediate;
    if (role == StreamRole::Points) return Flow::Scans;
    return streamFacts(role).picture ? Flow::Pictures : Flow::Telemetry;
}

TwistSample noNumber() {
    TwistSample twist;
    twist.linear.setConstant(std::numeric_limits<double>::quiet_NaN());
    return twist;
}

bool drives(StreamRole role) {
    return role == StreamRole::DriveCommand || role == StreamRole::TrackCommand;
}

}  // namespace

struct RobotWire::State {
    explicit State(const RobotDescription& description) : robot(description) {}

    Result<void> open(Node& node, Grants grants);
    void receive(const StreamDescription& stream, const ReceivedSample& sample);
    void receiveGrant(const ReceivedSample& sample);
    [[nodiscard]] Result<void> publish(const StreamDescription& stream, const Sample& sample);
    [[nodiscard]] Result<PictureSample> asVideo(const StreamDescription& stream,
                                                const PictureSample& picture);
    void put(ReceivedCommand command);
    void countBroken();

    const RobotDescription robot;
    std::map<std::string, std::unique_ptr<Publisher>> publishers;  ///< by topic; not changed after open()
    std::mutex filming;                                            ///< guards the one that follows
    std::map<std::string, VideoEncoder> videos;                    ///< by topic
    mutable std::mutex mutex;                                      ///< guards the two that follow
    std::vector<ReceivedCommand> waiting;
    RobotWireCounts counts;
    std::vector<std::unique_ptr<Subscription>> subscriptions;  ///< last: they call back
};

void RobotWire::State::put(ReceivedCommand command) {
    const std::lock_guard lock(mutex);
    ++counts.accepted;
    if (waiting.size() >= MostWaiting && !command.sample.is<StopCommandSample>()) {
        ++counts.dropped;
        return;
    }
    waiting.push_back(std::move(command));
}

void RobotWire::State::countBroken() {
    const std::lock_guard lock(mutex);
    ++counts.broken;
}

void RobotWire::State::receive(const StreamDescription& stream, const ReceivedSample& sample) {
    auto decoded = decode(sample.event, stream);
    if (!decoded) countBroken();
    if (!decoded && !drives(stream.role)) return;
    put({stream.role, false, decoded ? std::move(decoded).value() : Sample(noNumber()),
         senderOf(sample.writer), sample.event.received, stream.group});
}

void RobotWire::State::receiveGrant(const ReceivedSample& sample) {
    const auto event = decodeStationEvent(sample.event);
    if (!event || !event->sample.is<GrantSample>()) return countBroken();
    put({{}, true, event->sample, senderOf(sample.writer), sample.event.received});
}

Result<void> RobotWire::State::open(Node& node, Grants grants) {
    for (const StreamDescription& stream : robot.streams) {
        if (isCommand(stream.role)) {
            auto made =
                node.subscribe({stream.topic, stream.type, stream.qos, Lane::Small},
                               [this, stream](const ReceivedSample& sample) { receive(stream, sample); });
            if (!made) return made.error();
            subscriptions.push_back(std::move(made).value());
        } else if (!publishers.contains(stream.topic)) {
            auto made = node.publisher({stream.topic, stream.type, stream.qos, flowOf(stream.role)});
            if (!made) return made.error();
            publishers.emplace(stream.topic, std::move(made).value());
        }
    }
    if (grants == Grants::Unknown) return {};
    auto made = node.subscribe(
        {std::string(station_topic::Grants), "leitstand_msgs/msg/Grant", grantQos(), Lane::Small},
        [this](const ReceivedSample& sample) { receiveGrant(sample); });
    if (!made) return made.error();
    subscriptions.push_back(std::move(made).value());
    return {};
}

RobotWire::RobotWire(std::unique_ptr<State> state) : m_state(std::move(state)) {}

RobotWire::~RobotWire() {
    m_state->subscriptions.clear();
}

Result<std::unique_ptr<RobotWire>> RobotWire::create(Node& node, const RobotDescription& robot,
                                                     Grants grants) {
    std::unique_ptr<RobotWire> made(new RobotWire(std::make_unique<State>(robot)));
    if (auto opened = made->m_state->open(node, grants); !opened) return opened.error();
    return made;
}

std::vector<ReceivedCommand> RobotWire::take() {
    const std::lock_guard lock(m_state->mutex);
    return std::exchange(m_state->waiting, {});
}

Result<PictureSample> RobotWire::State::asVideo(const StreamDescription& stream,
                                                const PictureSample& picture) {
    const auto decoded = decodePicture(picture);
    if (!decoded) return decoded.error();
    VideoEncoding encoding;
    encoding.rate = streamFacts(stream.role).usualRate;
    const std::lock_guard lock(filming);
    auto bytes = videos.try_emplace(stream.topic, encoding).first->second.encode(*decoded);
    if (!bytes) return bytes.error();
    const auto content = std::make_shared<const std::vector<std::byte>>(std::move(bytes).value());
    PictureSample video;
    video.header = picture.header;
    video.compressed = true;
    video.encoding = "h264";
    video.width = decoded->width;
    video.height = decoded->height;
    video.content = {content, *content};
    video.video = std::make_shared<const VideoPacket>(VideoPacket{
        .codec = encoding.codec, .key = isKeyPicture(encoding.codec, *content), .bytes = video.content});
    return video;
}

Result<void> RobotWire::State::publish(const StreamDescription& stream, const Sample& sample) {
    Publisher& publisher = *publishers.at(stream.topic);
    const auto* picture = sample.as<PictureSample>();
    if (picture == nullptr || (picture->compressed && stream.type == CompressedPictures)) {
        const auto cdr = encode(sample, stream.type);
        return cdr ? publisher.write(*cdr) : Result<void>(cdr.error());
    }
    if (publisher.matched() == 0) {  // big, or dear: only sent when somebody listens
        const std::lock_guard lock(filming);
        videos.erase(stream.topic);  // who comes first sees a key picture
        return {};
    }
    auto made = stream.type == RawPictures          ? rawPicture(*picture)
                : stream.type == CompressedPictures ? compressedDepth(*picture)
                                                    : asVideo(stream, *picture);
    if (!made) return made.error();
    const auto cdr = encode(std::move(made).value(), stream.type);
    return cdr ? publisher.write(*cdr) : Result<void>(cdr.error());
}

void RobotWire::publish(const HardwareSample& sample) {
    const StreamDescription* first = m_state->robot.stream(sample.role, sample.sensor);
    if (first == nullptr) return;
    for (const StreamDescription& stream : m_state->robot.streams) {
        if (stream.role != first->role || stream.sensor != first->sensor) continue;
        const bool published = m_state->publish(stream, sample.sample).ok();
        const std::lock_guard lock(m_state->mutex);
        ++(published ? m_state->counts.published : m_state->counts.unpublished);
    }
}

RobotWireCounts RobotWire::counts() const {
    const std::lock_guard lock(m_state->mutex);
    return m_state->counts;
}

}  // namespace leitstand
