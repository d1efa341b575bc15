#include "app/window/panes/camera/camera_views.h"

#include <algorithm>

#include "core/event/stream_role.h"

namespace leitstand {
namespace {

/// Returns the cameras of @p robot in its file's order, the thermal ones last.
std::vector<const StreamDescription*> camerasOf(const RobotDescription& robot) {
    std::vector<const StreamDescription*> cameras;
    for (const StreamRole role : {StreamRole::Picture, StreamRole::Thermal}) {
        for (const StreamDescription& stream : robot.streams) {
            if (stream.role == role) cameras.push_back(&stream);
        }
    }
    return cameras;
}

}  // namespace

void CameraViews::select(const RobotDescription* robot) {
    m_robot = robot;
    m_streams.clear();
    if (robot == nullptr) return;
    m_streams = camerasOf(*robot);
    Choice first;
    if (!m_streams.empty()) first.large = m_streams.front()->sensor;
    if (m_streams.size() > 1) first.small = m_streams.back()->sensor;
    m_choices.try_emplace(robot->name, first);
}

void CameraViews::took(const ShownPicturePtr& picture, SteadyTime now) {
    Camera& camera = m_cameras[{picture->robot, picture->sensor}];
    // The same event again is the same picture with another look.
    if (!camera.newest || camera.newest->sequence != picture->sequence)
        camera.age.arrived(picture->fingerprint, now);
    camera.newest = picture;
}

void CameraViews::forget(const std::string& robot, const std::string& sensor) {
    m_cameras.erase({robot, sensor});
}

void CameraViews::next() {
    if (m_robot == nullptr || m_streams.size() < 2) return;
    Choice& choice = m_choices[m_robot->name];
    const auto now = std::find_if(m_streams.begin(), m_streams.end(),
                                  [&choice](const auto* stream) { return stream->sensor == choice.small; });
    auto at = static_cast<std::size_t>(now - m_streams.begin());
    for (std::size_t step = 0; step < m_streams.size(); ++step) {
        at = (at + 1) % m_streams.size();
        if (m_streams[at]->sensor == choice.large) continue;
        choice.small = m_streams[at]->sensor;
        return;
    }
}

void CameraViews::swap() {
    if (m_robot == nullptr) return;
    Choice& choice = m_choices[m_robot->name];
    if (!choice.small.empty()) std::swap(choice.large, choice.small);
}

const CameraViews::Choice* CameraViews::choice() const {
    const auto found = m_robot == nullptr ? m_choices.end() : m_choices.find(m_robot->name);
    return found == m_choices.end() ? nullptr : &found->second;
}

std::string CameraViews::sensor(CameraPlace place) const {
    const Choice* const chosen = choice();
    if (chosen == nullptr) return {};
    return place == CameraPlace::Large ? chosen->large : chosen->small;
}

const StreamDescription* CameraViews::stream(CameraPlace place) const {
    const auto found =
        std::find_if(m_streams.begin(), m_streams.end(),
                     [name = sensor(place)](const auto* stream) { return stream->sensor == name; });
    return found == m_streams.end() ? nullptr : *found;
}

const CameraViews::Camera* CameraViews::camera(CameraPlace place) const {
    if (m_robot == nullptr) return nullptr;
    const auto found = m_cameras.find({m_robot->name, sensor(place)});
    return found == m_cameras.end() ? nullptr : &found->second;
}

ShownPicturePtr CameraViews::newest(CameraPlace place) const {
    const Camera* const found = camera(place);
    return found == nullptr ? nullptr : found->newest;
}

DataAge CameraViews::age(CameraPlace place, SteadyTime now) const {
    const Camera* const found = camera(place);
    return found == nullptr ? DataAge{} : found->age.at(now);
}

DataAge CameraViews::age(const std::string& robot, const std::string& sensor, SteadyTime now) const {
    const auto found = m_cameras.find({robot, sensor});
    return found == m_cameras.end() ? DataAge{} : found->second.age.at(now);
}

}  // namespace leitstand
