#include "robots/control/driving/heat_cue.h"

#include <algorithm>
#include <cmath>

#include "core/base/rotation/heading.h"
#include "core/event/picture_samples.h"
#include "core/perception/heat/body_heat.h"

namespace leitstand {

Eigen::Isometry2d flat(const Pose& baseInOdom) {
    Eigen::Isometry2d result = Eigen::Isometry2d::Identity();
    result.rotate(headingOf(baseInOdom));
    result.pretranslate(Eigen::Vector2d(baseInOdom.translation().head<2>()));
    return result;
}

double bearingOf(const HeatCue& cue, const Pose& baseInOdom) {
    const Eigen::Vector2d towards = flat(baseInOdom).linear().transpose() * cue.ray.direction.head<2>();
    return std::atan2(towards.y(), towards.x());
}

Eigen::Vector3d placeOf(const HeatCue& cue, double away) {
    const double run = std::max(0.05, cue.ray.direction.head<2>().norm());
    return cue.ray.origin + cue.ray.direction * (away / run);
}

double heightAt(const HeatCue& cue, const Eigen::Vector2d& place, const Pose& baseInOdom) {
    const double away = (place - cue.ray.origin.head<2>()).norm();
    return placeOf(cue, away).z() - baseInOdom.translation().z();
}

std::vector<HeatCue> cuesFrom(const std::vector<HeatBlob>& blobs, const ThermalPicture& picture,
                              const CameraInfoSample& camera, const Pose& opticalInOdom, Time at) {
    std::vector<HeatCue> cues;
    for (const HeatBlob& blob : blobs) {
        if (blob.kind != HeatBlob::Kind::Body) continue;
        const auto direction = pixelDirection(camera, blob.centre, picture.width, picture.height);
        if (!direction) continue;
        const BodyHeat body = judgeBody(picture, blob, 1.0);
        cues.push_back({at, rayFrom(opticalInOdom, *direction), blob.width, blob.mean, blob.confidence,
                        blob.size, blob.cut, body.clothes, body.clothesCut});
    }
    return cues;
}

}  // namespace leitstand
