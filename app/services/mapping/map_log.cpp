#include "app/services/mapping/map_log.h"

#include <algorithm>
#include <utility>

#include "app/services/log/live_mission.h"
#include "app/services/mapping/live_mapping.h"
#include "app/services/mapping/mapping_text.h"
#include "app/services/places/mission_map.h"
#include "core/event/scan_bodies.h"
#include "core/event/station_samples.h"
#include "core/event/station_topics.h"

namespace leitstand {
namespace {

/// Whether the area @p now differs noticeably from @p before: smaller moves are not worth cutting all scans
/// again.
bool moved(const MapCrop& before, const MapCrop& now) {
    constexpr double Noticed = 0.03;  // [m]
    const auto same = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return (a - b).norm() < Noticed;
    };
    return before.ceiling != now.ceiling || !std::equal(before.polygon.begin(), before.polygon.end(),
                                                        now.polygon.begin(), now.polygon.end(), same);
}

/// Returns the station that published @p sample, if that is a decision on the map; else null.
const std::string* publisherOf(const Sample& sample) {
    if (const auto* links = sample.as<ScanLinksSample>()) return &links->station;
    if (const auto* poses = sample.as<ScanPosesSample>()) return &poses->station;
    if (const auto* undo = sample.as<UndoSample>()) return &undo->station;
    if (const auto* area = sample.as<MapCropSample>()) return &area->station;
    return nullptr;
}

}  // namespace

MapLog::MapLog(LiveMission& mission, MapLogSetup setup) : m_mission(mission), m_setup(std::move(setup)) {
    m_crop = cropInLog();
}

Result<void> MapLog::publish(const Sample& sample, std::string_view topic) {
    {
        const std::lock_guard lock(m_mutex);
        ++m_published;  // first: it may come back at once
    }
    auto kept = m_mission.record(sample, topic);
    if (kept) return kept;
    const std::lock_guard lock(m_mutex);
    ++m_received;
    return kept;
}

void MapLog::publishOrNotify(const Sample& sample, std::string_view topic) {
    if (const auto kept = publish(sample, topic); !kept) m_setup.notify(kept.error().text);
}

void MapLog::publishAside(const Sample& sample, std::string_view topic) {
    if (const auto kept = m_mission.record(sample, topic); !kept) m_setup.notify(kept.error().text);
}

void MapLog::publish(const MapUpdate& update) {
    if (update.keyScan) {
        {
            const std::lock_guard lock(m_mutex);
            m_registered.insert(update.keyScan->id);
        }
        publishAside(*update.keyScan, station_topic::KeyScans);
    }
    if (update.links) publishOrNotify(*update.links, station_topic::ScanLinks);
    if (update.poses) publishOrNotify(*update.poses, station_topic::ScanPoses);
    if (update.loop) publishLoop(*update.loop);
}

void MapLog::publishLoop(const ScanLinksSample& loop) {
    publishOrNotify(loop, station_topic::ScanLinks);
    const bool closes = loop.links.front().active;
    m_loopClosed = m_loopClosed || closes;
    m_closedByItself = m_closedByItself || closes;
    const bool parts = loop.links.front().kind == LinkKind::Session;
    if (!closes) m_setup.notify(parts ? mapping_words::partsMeet() : mapping_words::question());
}

void MapLog::publish(const Settled& settled) {
    if (settled.links) {
        publishOrNotify(*settled.links, station_topic::ScanLinks);
        m_setup.notify(mapping_words::contradicted());
    }
    if (settled.poses) publishOrNotify(*settled.poses, station_topic::ScanPoses);
    const bool byItself = std::exchange(m_closedByItself, false);
    if (!std::exchange(m_loopClosed, false) || settled.links) return;
    if (byItself) {
        const std::lock_guard lock(m_mutex);
        m_closed = {m_closed.count + 1, settled.largest};
    }
    m_setup.notify(mapping_words::met(settled.largest));
}

void MapLog::publish(const RobotPlaceSample& place) {
    publishAside(place, station_topic::RobotPlaces);
    const bool before = std::exchange(m_certain[place.robot], place.certain);
    if (place.cause == RobotPlaceSample::Cause::Tracked && before == place.certain) return;
    m_setup.notify(mapping_words::place(titleOf(place.robot), place));
}

void MapLog::publish(ScanBodiesSample bodies) {
    bodies.station = m_setup.station;
    publishAside(bodies, station_topic::ScanBodies);
}

void MapLog::onEvent(const Event& event) {
    if (event.sample.is<ClockOffsetSample>()) return m_mapping->onEvent(event);
    if (const auto* scan = event.sample.as<KeyScanSample>()) return onKeyScan(*scan);
    if (const auto* place = event.sample.as<RobotPlaceSample>()) {
        if (place->station != m_setup.station) m_mapping->follow(*place);
    } else if (const auto* bodies = event.sample.as<ScanBodiesSample>()) {
        if (bodies->station != m_setup.station) m_mapping->adopt(*bodies);
    } else {
        onDecision(event);
    }
}

void MapLog::onKeyScan(const KeyScanSample& scan) {
    {
        const std::lock_guard lock(m_mutex);
        if (m_registered.erase(scan.id) != 0) return;
    }
    m_mapping->adopt(scan);
}

void MapLog::onDecision(const Event& event) {
    const std::string* const publisher = publisherOf(event.sample);
    if (publisher == nullptr) return;
    const auto* links = event.sample.as<ScanLinksSample>();
    const auto* poses = event.sample.as<ScanPosesSample>();
    // From another station, which makes the map.
    if (links != nullptr && *publisher != m_setup.station) m_mapping->adopt(*links);
    if (poses != nullptr && *publisher != m_setup.station) m_mapping->follow(posesOf(*m_mission.state()));
    if (event.sample.is<UndoSample>()) {
        const std::lock_guard lock(m_mutex);
        m_settled.push_front([this](LiveMapper& mapper) {  // runs before what is decided after it
            const MissionStatePtr now = m_mission.state();
            mapper.follow(posesOf(*now));
            mapper.followLoops(loopsOf(*now));
        });
    }
    if (const auto crop = changedCrop(event, *publisher)) m_mapping->setCrop(*crop);
    const bool waits = [&] {
        const std::lock_guard lock(m_mutex);
        return !m_settled.empty();
    }();
    if (waits) m_mapping->post([this](LiveMapper& mapper) { runSettled(mapper); });
}

std::optional<MapCrop> MapLog::changedCrop(const Event& event, const std::string& publisher) {
    const bool undone = event.sample.is<UndoSample>(), area = event.sample.is<MapCropSample>(),
               poses = event.sample.is<ScanPosesSample>();
    const std::lock_guard lock(m_mutex);
    if (publisher == m_setup.station) ++m_received;
    m_cropMoved = m_cropMoved || undone || area || poses;
    // What was requested since is on its way.
    if (!m_cropMoved || m_received != m_published) return std::nullopt;
    m_cropMoved = false;
    const MapCrop now = cropInLog();
    if (!area && !undone && !moved(m_crop, now)) return std::nullopt;
    m_crop = now;
    return now;
}

void MapLog::whenSettled(std::function<void(LiveMapper&)> task) {
    m_mapping->post([this, task = std::move(task)](LiveMapper& mapper) {
        {
            const std::lock_guard lock(m_mutex);
            m_settled.push_back(task);
        }
        runSettled(mapper);
    });
}

bool MapLog::isSettled() const {
    const std::lock_guard lock(m_mutex);
    return m_received == m_published && m_settled.empty();
}

void MapLog::runSettled(LiveMapper& mapper) {
    while (true) {
        std::function<void(LiveMapper&)> next;
        {
            const std::lock_guard lock(m_mutex);
            if (m_settled.empty() || m_received < m_published) return;
            next = std::move(m_settled.front());
            m_settled.pop_front();
        }
        next(mapper);
    }
}

Result<void> MapLog::setCrop(const MapCrop& crop, Time at) {
    const MapCropSample sample{at, m_setup.station, crop.polygon, crop.ceiling};
    if (auto kept = publish(sample, station_topic::MapCrop); !kept) return kept;
    const std::lock_guard lock(m_mutex);
    m_crop = crop;  // the mapping follows the log
    return {};
}

MapCrop MapLog::crop() const {
    const std::lock_guard lock(m_mutex);
    return m_crop;
}

MapCrop MapLog::cropInLog() const {
    return cropOf(*m_mission.state()).value_or(m_setup.usualCrop);
}

ClosedLoops MapLog::closedLoops() const {
    const std::lock_guard lock(m_mutex);
    return m_closed;
}

const std::string& MapLog::titleOf(const std::string& robot) const {
    const auto found = m_setup.titles.find(robot);
    return found == m_setup.titles.end() || found->second.empty() ? robot : found->second;
}

}  // namespace leitstand
