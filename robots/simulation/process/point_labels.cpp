#include "robots/simulation/process/point_labels.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/cloud/scan.h"
#include "core/event/stream_role.h"
#include "robots/simulation/sensors/sensor_place.h"

namespace leitstand::simulation {
namespace {

constexpr float LookedBefore = 0.5F;  ///< a point's surface is looked for so far before and behind it [m]
constexpr float OwnHead = 0.13F;      ///< rays begin outside of the scanner's own housing [m]
constexpr float Near = 0.06F, NearOfRange = 0.01F;  ///< six deviations of the scanner's noise [m]

/// Returns the ray along which a point was measured, from shortly before to shortly behind it.
Ray rayTo(const Eigen::Vector3f& point, const Pose& mountInArena) {
    const float range = point.norm();
    Ray ray;
    ray.origin = mountInArena.translation().cast<float>();
    ray.direction = (mountInArena.linear().cast<float>() * point) / range;
    ray.near = std::max(range - LookedBefore, std::min(OwnHead, 0.9F * range));
    ray.far = range + LookedBefore;
    return ray;
}

Label labelOf(const Hit& hit, float range) {
    const bool belongs = hit.there() && std::abs(hit.distance - range) <= Near + NearOfRange * range;
    return belongs ? hit.surface->label : Label::Unlabelled;
}

}  // namespace

PointLabels::PointLabels(const RobotDescription& description, int robot) : m_robot(robot) {
    const auto place = placeOf(description, StreamRole::Points, {}, {});
    m_mountInBase = place ? place->inBase : Pose::Identity();
}

PictureSample PointLabels::of(const CloudSample& cloud, const World& world) const {
    const auto labels = std::make_shared<std::vector<std::uint8_t>>(cloud.points.size());
    for (std::size_t i = 0; i < cloud.points.size(); ++i) {
        const Eigen::Vector3f& point = cloud.points[i];
        if (!point.allFinite() || point.isZero()) continue;
        const std::chrono::nanoseconds after(cloud.times.empty() ? 0 : cloud.times[i]);
        const Pose mount = world.baseInArena(m_robot, cloud.header.stamp + after) * m_mountInBase;
        const Hit hit = world.scene().cast(rayTo(point, mount), RayKind::Laser);
        (*labels)[i] = static_cast<std::uint8_t>(labelOf(hit, point.norm()));
    }
    PictureSample picture;
    picture.header = cloud.header;
    picture.encoding = "mono8";
    picture.height = cloud.organised() ? cloud.rows : 1;
    picture.width = cloud.organised() ? cloud.columns : static_cast<int>(cloud.points.size());
    picture.step = static_cast<std::size_t>(picture.width);
    picture.content = {labels, std::as_bytes(std::span(*labels))};
    return picture;
}

}  // namespace leitstand::simulation
