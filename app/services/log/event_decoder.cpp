#include "app/services/log/event_decoder.h"

#include <utility>

#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/event/station_topics.h"
#include "transport/convert/decode.h"

namespace leitstand {

EventDecoder::EventDecoder(std::vector<RobotDescription> robots) : m_robots(std::move(robots)) {
    for (std::size_t robot = 0; robot < m_robots.size(); ++robot) {
        const auto& streams = m_robots[robot].streams;
        for (std::size_t stream = 0; stream < streams.size(); ++stream) {
            m_listings.emplace(streams[stream].topic, Listing{robot, stream});
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

void EventDecoder::decode(const RawEvent& event, const std::function<void(const Event&)>& take) {
    const auto give = [&](const Result<Event>& decoded) {
        if (decoded) {
            take(*decoded);
        } else {
            complain(event.topic, decoded.error().text);
        }
    };
    if (event.topic.starts_with(station_topic::Prefix)) return give(decodeStationEvent(event));
    const auto [first, last] = m_listings.equal_range(event.topic);
    for (auto listing = first; listing != last; ++listing) {
        const RobotDescription& robot = m_robots[listing->second.robot];
        give(decodeEvent(event, robot, robot.streams[listing->second.stream]));
    }
}

}  // namespace leitstand
