#include "app/services/finds/recent_evidence.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/robot/streams/stream_table.h"

namespace leitstand {
namespace {

void keepRecent(std::deque<Event>& kept, const Event& event, std::chrono::nanoseconds memory,
                std::size_t most) {
    kept.push_back(event);
    while (kept.size() > most || kept.front().received < event.received - memory) kept.pop_front();
}

bool isOlder(const Event& event, Time now, std::chrono::nanoseconds memory) {
    return event.received < now - memory;
}

std::optional<Event> ifRecent(const std::optional<Event>& event, Time now) {
    return event && !isOlder(*event, now, RecentEvidence::Silence) ? event : std::nullopt;
}

}  // namespace

void RecentEvidence::onEvent(const Event& event) {
    constexpr std::size_t MostGas = 1'000;
    if (event.robot.empty() || !event.role) return;
    const std::scoped_lock lock(m_mutex);
    Newest& newest = m_newest[event.robot];
    const StreamRole role = *event.role;
    if (streamFacts(role).picture) {
        keepRecent(m_pictures[{event.robot, event.sensor}], event, Pictures, MostPictures);
    } else if (const auto* info = event.sample.as<CameraInfoSample>()) {
        m_infos[{event.robot, event.sensor}] = *info;
    } else if (isScanner(role)) {
        newest.scan = event;
    } else if (role == StreamRole::Odometry) {
        newest.odometry = event;
    } else if (role == StreamRole::Sightings) {
        newest.sightings = event;
    } else if (role == StreamRole::Gas) {
        keepRecent(newest.gas, event, Gas, MostGas);
    }
}

RobotEvidence RecentEvidence::of(const std::string& robot, Time now, std::uint64_t pointed) const {
    const std::scoped_lock lock(m_mutex);
    RobotEvidence all;
    for (const auto& [camera, events] : m_pictures) {
        if (camera.first != robot || events.empty()) continue;
        auto& kept = events.back().role == StreamRole::Thermal ? all.thermal : all.pictures;
        std::vector<Event> recent;
        std::copy_if(events.begin(), events.end(), std::back_inserter(recent), [&](const Event& event) {
            return (pointed != 0 && event.sequence == pointed) || !isOlder(event, now, Pictures);
        });
        if (!recent.empty()) kept[camera.second] = std::move(recent);
    }
    for (const auto& [camera, info] : m_infos) {
        if (camera.first == robot) all.cameras[camera.second] = info;
    }
    const auto newest = m_newest.find(robot);
    if (newest == m_newest.end()) return all;
    all.scan = ifRecent(newest->second.scan, now);
    all.odometry = ifRecent(newest->second.odometry, now);
    all.sightings = ifRecent(newest->second.sightings, now);
    const std::deque<Event>& gas = newest->second.gas;
    if (gas.empty() || isOlder(gas.back(), now, Silence)) return all;
    std::copy_if(gas.begin(), gas.end(), std::back_inserter(all.gas),
                 [&](const Event& event) { return !isOlder(event, now, Gas); });
    return all;
}

}  // namespace leitstand
