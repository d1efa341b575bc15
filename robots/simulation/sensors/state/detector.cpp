#include "robots/simulation/sensors/state/detector.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

#include "core/event/map_samples.h"
#include "core/event/stream_role.h"

namespace leitstand::simulation {
namespace {

constexpr double Rate = 2.0;                   // [Hz]
constexpr double Reach = 5.0, OwnBody = 0.45;  // [m]
constexpr double Eye = 0.3;                    // above the base [m]
constexpr std::chrono::seconds Lifetime(2);
constexpr MarkerColour Colour = {0.2F, 0.9F, 0.5F, 1.0F};

bool isInSight(const World& world, int robot, const Pose& base, const Element& element) {
    const Eigen::Vector3d inBase = base.inverse() * element.pose.translation();
    if (inBase.norm() > Reach || inBase.x() < 0.0) return false;
    const Eigen::Vector3d eye = base * Eigen::Vector3d(0.0, 0.0, Eye);
    const Eigen::Vector3d way = element.pose.translation() - eye;
    Ray ray;
    ray.origin = eye.cast<float>();
    ray.direction = way.normalized().cast<float>();
    ray.far = static_cast<float>(way.norm() - OwnBody);
    return ray.far <= 0.0F || !world.scene().cast(ray, RayKind::Contact, robot).there();
}

}  // namespace

Detector::Detector(std::string frame, Time start) : m_frame(std::move(frame)), m_schedule(Rate, start) {}

void Detector::run(const World& world, int robot, std::vector<HardwareSample>& samples) {
    while (const auto stamp = m_schedule.due(world.now())) {
        if (!m_enabled) continue;
        const Pose base = world.baseInArena(robot, *stamp);
        MarkersSample seen;
        std::int32_t id = 0;
        for (const Element& element : world.arena().elements) {
            id += 2;
            const bool sought = element.victim || element.kind == ElementKind::Sign;
            if (!sought || !isInSight(world, robot, base, element)) continue;
            Marker box;
            box.header = {*stamp, m_frame};
            box.space = "detections";
            box.id = id;
            box.markerInFrame = base.inverse() * element.pose;
            box.size = element.size.cwiseMax(0.05);
            box.colour = Colour;
            box.lifetime = Lifetime;
            Marker name = box;
            name.id = id + 1;
            name.shape = MarkerShape::Text;
            name.text = element.victim ? "person" : element.text;
            seen.markers.push_back(std::move(box));
            seen.markers.push_back(std::move(name));
        }
        samples.push_back({StreamRole::Markers, {}, std::move(seen)});
    }
}

bool Detector::configure(StreamRole role, const std::string& /*sensor*/, const StreamSettings& settings) {
    if (role != StreamRole::Markers) return false;
    m_enabled = settings.enabled;
    m_schedule.setRate(settings.rate > 0.0 ? std::min(settings.rate, Rate) : Rate);
    return true;
}

}  // namespace leitstand::simulation
