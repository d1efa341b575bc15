#include "core/mission/finds/placed_cue.h"

#include <cmath>

namespace leitstand {

void placeByRay(PlacedCue& cue, const Ray& ray, const RayHit& hit, double spread, bool certainPose,
                const PlacingSettings& settings) {
    const Eigen::Vector3d along = ray.direction.normalized();
    cue.from = ray.origin;
    cue.inMap = ray.origin + hit.range * along;
    const double pose = certainPose ? settings.pose : settings.doubted;
    const double angle = std::hypot(settings.pixel, settings.heading, 0.35 * spread);
    const double across = std::hypot(angle * hit.range, pose);
    const double deep = std::hypot(hit.scatter, settings.surface, pose);
    const Eigen::Matrix3d towards = along * along.transpose();
    cue.covariance = deep * deep * towards + across * across * (Eigen::Matrix3d::Identity() - towards);
}

}  // namespace leitstand
