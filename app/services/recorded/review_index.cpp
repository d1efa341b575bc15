#include "app/services/recorded/review_index.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "app/services/recorded/review_log.h"
#include "app/services/recorded/review_opening.h"
#include "core/base/pose.h"
#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "core/event/station_topics.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

constexpr std::chrono::seconds Silence(10);  ///< longer gaps separate stretches
constexpr std::chrono::milliseconds ReadingsApart(200);
constexpr double TurnedApart = degrees(10);  ///< of points on a track

std::vector<std::string> topicsOf(const std::vector<RobotDescription>& robots) {
    std::vector<std::string> topics;
    for (const auto topic :
         {station_topic::Victims, station_topic::Candidates, station_topic::KeyScans,
          station_topic::ScanPoses, station_topic::RobotPlaces, station_topic::Undo, station_topic::Notes,
          station_topic::Sessions, station_topic::Alarms, station_topic::Clock, station_topic::Grants})
        topics.emplace_back(topic);
    for (const RobotDescription& robot : robots) {
        for (const StreamDescription& stream : robot.streams) {
            const bool heavy = isPictureType(stream.type) || stream.type == "sensor_msgs/msg/PointCloud2";
            if (streamFacts(stream.role).indexed && !heavy) topics.push_back(stream.topic);
        }
    }
    return topics;
}

class Indexing {
public:
    void onEvent(const Event& event);
    ReviewIndex index;
    TimelineCollector marks;

private:
    /// When odometry of a robot was received.
    struct Gap {
        std::optional<Time> last;
        std::chrono::nanoseconds silence{};  ///< the longest since the track's end
    };
    void follow(const Event& event, const OdometrySample& odometry);

    std::map<std::string, Gap> m_gaps;  ///< by robot
};

void Indexing::follow(const Event& event, const OdometrySample& odometry) {
    auto& track = index.tracks[event.robot];
    const Pose& base = odometry.baseInOdom;
    if (!base.matrix().allFinite()) return;
    Gap& gap = m_gaps[event.robot];
    if (gap.last) gap.silence = std::max(gap.silence, std::chrono::nanoseconds(event.received - *gap.last));
    gap.last = event.received;
    if (!track.empty()) {
        const Pose& before = track.back().baseInOdom;
        const bool moved = (before.translation() - base.translation()).norm() >= ReviewIndex::TrackApart ||
                           angleBetween(before, base) >= TurnedApart;
        if (!moved) return;
    }
    const Time stamp = odometry.header.stamp == Time{} ? event.received : odometry.header.stamp;
    track.push_back({event.received, stamp, base, std::exchange(gap.silence, {})});
}

void Indexing::onEvent(const Event& event) {
    auto& stretches = index.stretches;
    if (stretches.empty() || event.received > stretches.back().to + Silence)
        stretches.push_back({event.received, event.received});
    stretches.back().to = std::max(stretches.back().to, event.received);
    if (!event.robot.empty()) index.lastReceived = event.received;
    marks.add(event);
    if (const auto* odometry = event.sample.as<OdometrySample>()) {
        follow(event, *odometry);
    } else if (const auto* scan = event.sample.as<KeyScanSample>()) {
        if (scan->scan) {
            index.scanned[scan->scan->robot].push_back(event.received);
            index.keyScans.insert_or_assign(scan->id, *scan);
        }
    } else if (const auto* place = event.sample.as<RobotPlaceSample>()) {
        index.places[place->robot].push_back(*place);
    } else if (const auto* gas = event.sample.as<GasSample>()) {
        index.gas[event.robot].emplace_back(event.received, gas->ppm);
    } else if (const auto* reading = event.sample.as<ReadingSample>()) {
        auto& kept = index.readings[{event.robot, event.topic}];
        kept.resize(std::max(kept.size(), reading->values.size()));
        for (std::size_t i = 0; i < reading->values.size(); ++i) {
            if (kept[i].empty() || event.received - kept[i].back().first >= ReadingsApart)
                kept[i].emplace_back(event.received, reading->values[i]);
        }
    } else if (event.role == StreamRole::StaticTransforms) {
        index.fixed.push_back(event);
    }
}

}  // namespace

ReviewIndexPtr indexOf(ReviewLog& log, const Progress& progress) {
    Indexing work;
    log.all(topicsOf(log.robots()), progress, [&work](const Event& event) { work.onEvent(event); });
    if (work.index.stretches.empty()) work.index.stretches.push_back({log.first(), log.last()});
    work.index.marks = work.marks.marks();
    work.index.finished = std::make_shared<const MissionState>(log.stateAt(log.last()));
    dropUndone(work.index.marks, *work.index.finished);
    work.index.opensAt = openingOf(log, work.index);
    return std::make_shared<const ReviewIndex>(std::move(work.index));
}

}  // namespace leitstand
