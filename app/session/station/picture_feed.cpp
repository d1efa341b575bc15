#include "app/session/station/picture_feed.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/perception/content_hash.h"
#include "core/perception/picture_decoding.h"

namespace leitstand {
PictureFeed::PictureFeed(std::vector<RobotDescription> robots, Listener listener)
    : m_robots(std::move(robots)),
      m_listener(std::move(listener)),
      m_thread([this](const std::stop_token& stop) { run(stop); }) {}

PictureFeed::~PictureFeed() = default;

void PictureFeed::take(const Event& event) {
    if (!std::holds_alternative<PictureSample>(event.sample)) return;
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.insert_or_assign({event.robot, event.sensor}, event);
    }
    m_came.notify_all();
}

void PictureFeed::run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        std::map<Camera, Event> taken;
        {
            std::unique_lock lock(m_mutex);
            if (!m_came.wait(lock, stop, [this] { return !m_waiting.empty(); })) return;
            taken.swap(m_waiting);
        }
        for (const auto& [camera, event] : taken) {
            if (stop.stop_requested()) return;
            decode(event);
        }
    }
}

const ThermalScale* PictureFeed::scaleOf(const Event& event) const {
    if (event.role != StreamRole::Thermal) return nullptr;
    for (const RobotDescription& robot : m_robots) {
        if (robot.name != event.robot) continue;
        const StreamDescription* stream = robot.stream(StreamRole::Thermal, event.sensor);
        return stream != nullptr && stream->thermal.measured ? &stream->thermal : nullptr;
    }
    return nullptr;
}

void PictureFeed::decode(const Event& event) {
    const auto& sample = std::get<PictureSample>(event.sample);
    auto shown = std::make_shared<ShownPicture>();
    shown->robot = event.robot;
    shown->sensor = event.sensor;
    shown->stamp = sample.header.stamp;
    shown->received = event.received;
    shown->fingerprint = contentHash(sample.content.bytes);
    const auto fail = [&](const std::string& why) {
        std::string& told = m_problems[{event.robot, event.sensor}];
        if (told == why) return;
        told = why;
        if (m_listener.onProblem) m_listener.onProblem(fmt::format("{}: {}", event.topic, why));
    };
    auto picture = decodePicture(sample);
    if (!picture) return fail(picture.error().text);
    if (const ThermalScale* scale = scaleOf(event)) {
        auto heat = temperatures(*picture, *scale);
        if (!heat) return fail(heat.error().text);
        shown->content = std::move(heat).value();
    } else {
        shown->content = std::move(picture).value();
    }
    if (m_listener.onPicture) m_listener.onPicture(shown);
}

}  // namespace leitstand
