#include "app/services/log/log_entry.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>

#include "app/services/log/event_decoder.h"
#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/event/raw_event.h"
#include "core/event/stream_role.h"
#include "core/io/bag/bag_reader.h"
#include "core/io/bag/raw_events.h"
#include "core/perception/pictures/video/video_packet.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {

std::vector<RawEvent> videoUpTo(BagReader& bag, EventDecoder& decoder, const std::string& topic,
                                std::uint64_t sequence) {
    // Usual intervals between key pictures first.
    constexpr std::array<std::chrono::seconds, 3> Reaches = {std::chrono::seconds(2), std::chrono::seconds(6),
                                                             std::chrono::seconds(20)};
    const auto newest = bag.lastUpTo(topic, sequence);
    if (!newest) return {};
    for (const auto reach : Reaches) {
        decoder.jump(topic);
        std::vector<RawEvent> found;
        bool video = true, whole = false;
        BagQuery query;
        query.topics = {topic};
        query.from = newest->received - reach;
        query.toSequence = sequence;
        forEachRaw(bag, query, [&](RawEvent& raw) {
            decoder.decode(raw, [&](const Event& event) {
                const auto* const picture = event.sample.as<PictureSample>();
                video = picture != nullptr && picture->video != nullptr;
                if (!video) return;
                if (picture->video->key) found.clear();
                whole = picture->video->decodable();
            });
            if (video) found.push_back(std::move(raw));
            return video;
        });
        if (!video) return {};
        if (whole) return found;
    }
    return {};
}

namespace {

/// Whether @p topic carries videos: by its type, or by what came on it. The newest event up to @p sequence is
/// looked at once for that.
bool isVideo(BagReader& bag, EventDecoder& decoder, const BagTopic& topic, std::uint64_t sequence) {
    const std::string& name = topic.info.name;
    if (!isPictureType(topic.info.type) || topic.info.type == "sensor_msgs/msg/Image") return false;
    if (topic.info.type == "sensor_msgs/msg/CompressedImage" && !decoder.hasSeen(name)) {
        if (const auto raw = bag.lastUpTo(name, sequence)) decoder.decode(*raw, [](const Event&) {});
    }
    return topic.info.type != "sensor_msgs/msg/CompressedImage" || decoder.isVideo(name);
}

/// Reads the calibration of the camera that sends the depth pictures of @p depths: the newest one before @p
/// sequence, or the first one after.
void readCalibration(BagReader& bag, EventDecoder& decoder, const RobotDescription& robot,
                     const StreamDescription& depths, std::uint64_t sequence) {
    const StreamDescription* const info = robot.stream(StreamRole::CameraInfo, depths.sensor);
    if (info == nullptr) return;
    auto raw = bag.lastUpTo(info->topic, sequence);
    if (!raw) {
        BagQuery query;
        query.topics = {info->topic};
        query.fromSequence = sequence + 1;
        raw = bag.read(query).next();
    }
    if (raw) decoder.decode(*raw, [](const Event&) {});
}

}  // namespace

void enterLog(BagReader& bag, EventDecoder& decoder, std::uint64_t sequence,
              const std::vector<std::string>& topics) {
    const auto isRead = [&](const std::string& topic) {
        return topics.empty() || std::find(topics.begin(), topics.end(), topic) != topics.end();
    };
    if (decoder.goesOn(sequence, topics)) return;
    decoder.jump();
    for (const RobotDescription& robot : decoder.robots()) {
        for (const StreamDescription& stream : robot.streams) {
            if (isDepthStream(stream) && isRead(stream.topic) &&
                !decoder.isCalibrated(robot.name, stream.sensor))
                readCalibration(bag, decoder, robot, stream, sequence);
        }
    }
    if (sequence == 0) return;
    for (const BagTopic& topic : bag.topics()) {
        const std::string& name = topic.info.name;
        if (isRead(name) && decoder.knows(name) && isVideo(bag, decoder, topic, sequence))
            (void)videoUpTo(bag, decoder, name, sequence);
    }
}

std::optional<Event> decodedAlone(BagReader& bag, EventDecoder& decoder, const RawEvent& event) {
    if (isPictureType(event.type) && event.sequence > 0)
        enterLog(bag, decoder, event.sequence - 1, {event.topic});
    std::optional<Event> found;
    decoder.decode(event, [&](const Event& decoded) {
        if (!found) found = decoded;
    });
    return found;
}

}  // namespace leitstand
