#include "app/services/station/cameras/picture_feed.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "core/event/picture_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/pictures/content_hash.h"
#include "core/perception/pictures/video/video_packet.h"

namespace leitstand {
namespace {

constexpr int MostWaited = 150;  ///< pictures of a video until the operator hears that a key picture lacks

}  // namespace

PictureFeed::PictureFeed(std::vector<RobotDescription> robots, Listener listener)
    : m_robots(std::move(robots)),
      m_listener(std::move(listener)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

PictureFeed::~PictureFeed() = default;

void PictureFeed::onEvent(const Event& event) {
    const Camera camera(event.robot, event.sensor);
    if (const auto* info = event.sample.as<CameraInfoSample>()) {
        const std::lock_guard lock(m_mutex);
        m_infos[camera] = std::make_shared<const CameraInfoSample>(*info);
        return;
    }
    if (!event.sample.is<PictureSample>()) return;
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.insert_or_assign(camera, event);
        m_newest.insert_or_assign(camera, event);
    }
    m_came.notify_all();
}

void PictureFeed::setLook(const std::string& robot, const std::string& sensor, const PictureLook& look) {
    {
        const std::lock_guard lock(m_mutex);
        const Camera camera(robot, sensor);
        if (std::exchange(m_looks[camera], look) == look) return;
        const auto newest = m_newest.find(camera);
        if (newest == m_newest.end()) return;
        m_waiting.insert_or_assign(camera, newest->second);
    }
    m_came.notify_all();
}

void PictureFeed::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::vector<Work> taken;
        {
            std::unique_lock lock(m_mutex);
            if (!m_came.wait(lock, stop, [this] { return !m_waiting.empty(); })) return;
            for (auto& [camera, event] : m_waiting) {
                const auto info = m_infos.find(camera);
                taken.push_back(
                    {std::move(event), m_looks[camera], info == m_infos.end() ? nullptr : info->second});
            }
            m_waiting.clear();
        }
        for (const Work& work : taken) {
            if (stop.stop_requested()) return;
            decode(work, stop);
        }
    }
}

const RobotDescription* PictureFeed::robot(const std::string& name) const {
    const auto found = std::find_if(m_robots.begin(), m_robots.end(),
                                    [&name](const RobotDescription& one) { return one.name == name; });
    return found == m_robots.end() ? nullptr : &*found;
}

const ThermalScale* PictureFeed::scaleOf(const Event& event) const {
    const RobotDescription* const from = robot(event.robot);
    if (event.role != StreamRole::Thermal || from == nullptr) return nullptr;
    const StreamDescription* stream = from->stream(StreamRole::Thermal, event.sensor);
    return stream != nullptr && stream->thermal.measured ? &stream->thermal : nullptr;
}

const Panorama* PictureFeed::panoramaOf(const Work& work, const Picture& picture) {
    if (!work.look.unwrapped || !work.info) return nullptr;
    const Camera camera(work.event.robot, work.event.sensor);
    const auto made = m_panoramas.find(camera);
    if (made != m_panoramas.end() && made->second.fits(*work.info, picture.width, picture.height))
        return &made->second;
    const RobotDescription* const from = robot(camera.first);
    if (from == nullptr || !from->sensors.contains(camera.second)) return nullptr;
    auto panorama =
        Panorama::of(*work.info, picture.width, picture.height, from->sensors.at(camera.second).sensorInBase);
    if (!panorama) return nullptr;
    return &m_panoramas.insert_or_assign(camera, *std::move(panorama)).first->second;
}

void PictureFeed::apply(const Work& work, Picture picture, ShownPicture& shown) {
    if (const Panorama* const panorama = panoramaOf(work, picture)) {
        picture = panorama->unwrapped(picture);
        shown.panorama = panorama->shape();
    }
    // Changed contrast would show other temperatures in false colours.
    if (work.event.role == StreamRole::Picture && work.look.contrast != ContrastHelp::Off) {
        picture = withContrast(picture, work.look.contrast);
        shown.contrast = work.look.contrast;
    }
    shown.content = std::move(picture);
}

void PictureFeed::decode(const Work& work, const std::stop_token& stop) {
    const Event& event = work.event;
    const auto& sample = event.sample.get<PictureSample>();
    auto shown = std::make_shared<ShownPicture>();
    shown->robot = event.robot;
    shown->sensor = event.sensor;
    shown->sequence = event.sequence;
    shown->sample = sample;
    shown->stamp = sample.header.stamp;
    shown->received = event.received;
    shown->fingerprint = contentHash(sample.content.bytes);
    shown->camera = work.info;
    const auto fail = [&](const std::string& why) {
        std::string& reported = m_problems[{event.robot, event.sensor}];
        if (reported == why) return;
        reported = why;
        if (m_listener.onProblem) m_listener.onProblem(fmt::format("{}: {}", event.topic, why));
    };
    if (sample.video && !sample.video->decodable() && sample.video->waited < MostWaited) return;
    auto picture = m_decoders[{event.robot, event.sensor}].decode(sample, stop);
    if (!picture) return fail(picture.error().text);
    shown->width = picture->width;
    shown->height = picture->height;
    if (const ThermalScale* scale = scaleOf(event)) {
        auto heat = temperatures(*picture, *scale);
        if (!heat) return fail(heat.error().text);
        shown->heat = findHeat(*heat, work.info ? *work.info : CameraInfoSample{});
        shown->content = std::move(heat).value();
    } else {
        apply(work, std::move(picture).value(), *shown);
    }
    if (m_listener.onPicture) m_listener.onPicture(shown);
}

}  // namespace leitstand
