#include "app/session/finds/recent_evidence.h"

namespace leitstand {
namespace {

void keepRecent(std::deque<Event>& kept, const Event& event, std::chrono::nanoseconds memory,
                std::size_t most) {
    kept.push_back(event);
    while (kept.size() > most || kept.front().received < event.received - memory) kept.pop_front();
}

}  // namespace

void RecentEvidence::take(const Event& event) {
    constexpr std::size_t MostGas = 1'000;
    if (event.robot.empty() || !event.role) return;
    const std::scoped_lock lock(m_mutex);
    Newest& newest = m_newest[event.robot];
    switch (*event.role) {
        case StreamRole::Picture:
        case StreamRole::Thermal:
            keepRecent(m_pictures[{event.robot, event.sensor}], event, Pictures, MostPictures);
            break;
        case StreamRole::CameraInfo:
            if (const auto* info = std::get_if<CameraInfoSample>(&event.sample))
                m_infos[{event.robot, event.sensor}] = *info;
            break;
        case StreamRole::Points:
        case StreamRole::Ranges:
            newest.scan = event;
            break;
        case StreamRole::Odometry:
            newest.odometry = event;
            break;
        case StreamRole::Sightings:
            newest.sightings = event;
            break;
        case StreamRole::Gas:
            keepRecent(newest.gas, event, Gas, MostGas);
            break;
        default:
            break;
    }
}

RobotEvidence RecentEvidence::of(const std::string& robot) const {
    const std::scoped_lock lock(m_mutex);
    RobotEvidence all;
    for (const auto& [camera, events] : m_pictures) {
        if (camera.first != robot || events.empty()) continue;
        auto& kept = events.back().role == StreamRole::Thermal ? all.thermal : all.pictures;
        kept[camera.second] = {events.begin(), events.end()};
    }
    for (const auto& [camera, info] : m_infos) {
        if (camera.first == robot) all.cameras[camera.second] = info;
    }
    const auto newest = m_newest.find(robot);
    if (newest == m_newest.end()) return all;
    all.scan = newest->second.scan;
    all.odometry = newest->second.odometry;
    all.sightings = newest->second.sightings;
    all.gas = {newest->second.gas.begin(), newest->second.gas.end()};
    return all;
}

}  // namespace leitstand
