#include "app/services/log/event_decoder.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "core/event/cloud_sample.h"
#include "core/event/event.h"
#include "core/event/picture_samples.h"
#include "core/event/raw_event.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"
#include "transport/convert/decode.h"

namespace leitstand {

EventDecoder::EventDecoder(std::vector<RobotDescription> robots) : m_robots(std::move(robots)) {
    for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
        const auto& streams = m_robots[robot].streams;
        for (std::size_t stream = 0; stream < streams.size(); ++stream) {
            m_listings.emplace(streams[stream].topic, Listing{robot, stream});
            if (isDepthStream(streams[stream]))
                m_depths.try_emplace({m_robots[robot].name, streams[stream].sensor});
        }
    }
}

bool EventDecoder::knows(const std::string& topic) const {
    return topic.starts_with(station_topic::Prefix) || m_listings.contains(topic);
}

void EventDecoder::complain(const std::string& topic, const std::string& text) {
    DecodingErrors& errors = m_errors[topic];
    ++errors.count;
    errors.last = text;
}

bool EventDecoder::isCalibrated(const std::string& robot, const std::string& sensor) const {
    const auto camera = m_depths.find({robot, sensor});
    return camera == m_depths.end() || camera->second.calibration.has_value();
}

Result<std::optional<Event>> EventDecoder::asCloud(Event event) {
    constexpr int Patience = 50;
    DepthCamera& camera = m_depths[{event.robot, event.sensor}];
    if (!camera.calibration) {
        if (++camera.waiting < Patience) return std::optional<Event>();
        return Error{
            fmt::format("{}: depth pictures, but no camera_info of \"{}\"", event.topic, event.sensor)};
    }
    constexpr std::chrono::milliseconds Apart(180);
    if (camera.last && event.received >= *camera.last && event.received - *camera.last < Apart)
        return std::optional<Event>();
    camera.last = event.received;
    if (!m_depthContent) {
        CloudSample none;
        none.header = event.sample.as<PictureSample>()->header;
        event.sample = Sample(std::move(none));
        return std::optional(std::move(event));
    }
    auto cloud = camera.clouds.of(*event.sample.as<PictureSample>(), *camera.calibration);
    if (!cloud) return Error{fmt::format("{}: {}", event.topic, cloud.error().text)};
    event.sample = Sample(std::move(cloud).value());
    return std::optional(std::move(event));
}

Result<std::optional<Event>> EventDecoder::finished(Event event) {
    if (const auto* const info = event.sample.as<CameraInfoSample>()) {
        const auto depths = m_depths.find({event.robot, event.sensor});
        if (depths != m_depths.end()) depths->second.calibration = *info;
    } else if (const auto* const picture = event.sample.as<PictureSample>()) {
        if (event.role == StreamRole::Points) return asCloud(std::move(event));
        if (picture->video) m_videos.link(event.topic, *event.sample.edit<PictureSample>());
    }
    return std::optional(std::move(event));
}

void EventDecoder::decode(const RawEvent& event, const std::function<void(const Event&)>& take) {
    const auto give = [&](Result<Event> decoded) {
        if (!decoded) return complain(event.topic, decoded.error().text);
        const auto done = finished(std::move(decoded).value());
        if (!done) return complain(event.topic, done.error().text);
        if (*done) take(**done);
    };
    if (event.topic.starts_with(station_topic::Prefix)) return give(decodeStationEvent(event));
    m_seen.insert(event.topic);
    const auto [first, last] = m_listings.equal_range(event.topic);
    for (auto listing = first; listing != last; ++listing) {
        const RobotDescription& robot = m_robots[listing->second.robot];
        give(decodeEvent(event, robot, robot.streams[listing->second.stream]));
    }
}

}  // namespace leitstand
