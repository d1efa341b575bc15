#include "app/session/coverage/logged_views.h"

#include <algorithm>
#include <map>

#include "app/session/coverage/view_search.h"
#include "app/session/log/mission_robots.h"
#include "core/mission/coverage/search_book.h"
#include "core/mission/station_topics.h"

namespace leitstand {

std::vector<SearchView> loggedViews(BagReader& bag, EventDecoder& decoder, const Progress& progress) {
    BagQuery query;
    query.topics = {std::string(station_topic::KeyScans), std::string(station_topic::ScanPoses),
                    std::string(station_topic::RobotPlaces)};
    std::map<std::string, Time> pictures;  // newest that was decoded, by topic
    for (const RobotDescription& robot : decoder.robots()) {
        for (const StreamDescription& stream : robot.streams) {
            switch (stream.role) {
                case StreamRole::Picture:
                case StreamRole::Thermal:
                    pictures[stream.topic] = Time{};
                    [[fallthrough]];
                case StreamRole::Odometry:
                case StreamRole::Imu:
                case StreamRole::Transforms:
                case StreamRole::StaticTransforms:
                case StreamRole::CameraInfo:
                    query.topics.push_back(stream.topic);
                    break;
                default:
                    break;
            }
        }
    }
    ViewSearch search(decoder.robots());
    SearchBook book;
    BagCursor cursor = bag.read(query);
    const auto last = static_cast<double>(std::max<std::uint64_t>(1, bag.lastSequence()));
    while (const auto raw = cursor.next()) {
        if (const auto picture = pictures.find(raw->topic); picture != pictures.end()) {
            const bool soon =
                raw->received >= picture->second && raw->received - picture->second < ViewFinder::Every;
            if (soon) continue;
            picture->second = raw->received;
        }
        decoder.decode(*raw, [&](const Event& event) { search.take(event); });
        for (const SearchView& view : search.found()) (void)book.add(view);
        progress.done(static_cast<double>(raw->sequence) / last);
        if (progress.cancelled()) break;
    }
    return book.allViews();
}

std::vector<SearchView> loggedViews(const std::filesystem::path& folder, const Progress& progress) {
    const auto bag = BagReader::open(folder);
    if (!bag) return {};
    std::vector<std::string> ignored;  // who opens the mission says so
    EventDecoder decoder(robotsOf(folder, **bag, ignored));
    return loggedViews(**bag, decoder, progress);
}

}  // namespace leitstand
