#include "app/services/coverage/logged_views.h"

#include <algorithm>
#include <array>
#include <map>

#include "app/services/coverage/view_search.h"
#include "app/services/log/mission_robots.h"
#include "app/services/places/mission_map.h"
#include "core/event/map_samples.h"
#include "core/event/raw_event.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"
#include "core/event/stream_role.h"
#include "core/io/bag/raw_events.h"
#include "core/mission/coverage/search_book.h"
#include "core/mission/state/fold.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {

namespace {

/// A search in a log, whose events hold what was taken back.
class LoggedSearch {
public:
    explicit LoggedSearch(const std::vector<RobotDescription>& robots) : m_search(robots) {}

    void onEvent(const Event& event) {
        const bool undo = event.sample.is<UndoSample>();
        if (undo || event.sample.is<KeyScanSample>() || event.sample.is<ScanPosesSample>())
            m_decisions.add(event);
        if (undo) return m_search.follow(posesOf(m_decisions.state()));
        m_search.onEvent(event);
        for (const SearchView& view : m_search.found()) (void)m_book.add(view);
    }
    [[nodiscard]] LoggedViews views() const { return {m_book.allViews(), m_book.leftOut()}; }

private:
    ViewSearch m_search;
    SearchBook m_book;
    Fold m_decisions;  ///< on scans
};

/// Whether streams of @p role describe where a camera was, or how it sees.
bool describesViews(StreamRole role) {
    constexpr std::array Roles = {StreamRole::Odometry, StreamRole::Imu, StreamRole::Transforms,
                                  StreamRole::StaticTransforms, StreamRole::CameraInfo};
    return std::find(Roles.begin(), Roles.end(), role) != Roles.end();
}

}  // namespace

LoggedViews loggedViews(BagReader& bag, EventDecoder& decoder, const Progress& progress) {
    BagQuery query;
    query.topics = {std::string(station_topic::KeyScans), std::string(station_topic::ScanPoses),
                    std::string(station_topic::RobotPlaces), std::string(station_topic::Undo)};
    std::map<std::string, Time> pictures;  // newest that was decoded, by topic
    for (const RobotDescription& robot : decoder.robots()) {
        for (const StreamDescription& stream : robot.streams) {
            const bool picture = streamFacts(stream.role).picture;
            if (picture) pictures[stream.topic] = Time{};
            if (picture || describesViews(stream.role)) query.topics.push_back(stream.topic);
        }
    }
    LoggedSearch search(decoder.robots());
    const auto take = [&](const RawEvent& raw) {
        if (const auto picture = pictures.find(raw.topic); picture != pictures.end()) {
            const bool soon =
                raw.received >= picture->second && raw.received - picture->second < ViewFinder::Every;
            if (soon) return true;
            picture->second = raw.received;
        }
        decoder.decode(raw, [&](const Event& event) { search.onEvent(event); });
        return true;
    };
    forEachRaw(bag, query, take, progress);
    return search.views();
}

LoggedViews loggedViews(const std::filesystem::path& folder, const Progress& progress) {
    const auto bag = BagReader::open(folder);
    if (!bag) return {};
    std::vector<std::string> ignored;  // reported by whoever opens the mission
    EventDecoder decoder(robotsOf(folder, **bag, ignored));
    return loggedViews(**bag, decoder, progress);
}

}  // namespace leitstand
