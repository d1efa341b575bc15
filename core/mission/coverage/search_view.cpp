#include "core/mission/coverage/search_view.h"

#include <algorithm>
#include <cmath>

#include "core/event/picture_samples.h"
#include "core/perception/omni/mei_camera.h"
#include "core/perception/pictures/pixel_ray.h"

namespace leitstand {
namespace {

/// Returns the ring that a camera below a mirror, or with a fisheye, sees, up to the picture's edge nearest
/// to its axis. @p project returns the pixel of a direction.
template <class Project>
std::optional<SearchField> ringOf(const CameraInfoSample& info, const Project& project) {
    const std::optional<Eigen::Vector2d> middle = project(Eigen::Vector3d(Eigen::Vector3d::UnitZ()));
    if (!middle) return std::nullopt;
    const double reach =
        std::min({middle->x(), middle->y(), info.width - middle->x(), info.height - middle->y()});
    constexpr double Step = degrees(1);
    SearchField field;
    double before = 0.0;
    for (double angle = Step; angle < degrees(170); angle += Step) {
        const std::optional<Eigen::Vector2d> pixel =
            project(Eigen::Vector3d(std::sin(angle), 0.0, std::cos(angle)));
        if (!pixel || !pixel->allFinite()) break;
        const double radius = (*pixel - *middle).norm();
        if (radius > reach || radius <= before) break;
        field.outer = angle;
        // The coarsest place counts: elsewhere a body spans more pixels.
        const double density = (radius - before) / Step;
        field.pixelsPerRadian =
            field.pixelsPerRadian > 0.0 ? std::min(field.pixelsPerRadian, density) : density;
        before = radius;
    }
    if (!(field.outer > 0.0)) return std::nullopt;
    return field;
}

std::optional<SearchField> ringOf(const CameraInfoSample& info) {
    if (isFisheye(info)) {
        return ringOf(info, [&](const Eigen::Vector3d& direction) {
            return pixelOf(info, direction, info.width, info.height);
        });
    }
    const auto mirror = MeiCamera::of(info, info.width, info.height);
    if (!mirror) return std::nullopt;
    return ringOf(info, [&](const Eigen::Vector3d& direction) { return mirror->project(direction); });
}

}  // namespace

std::string_view nameOf(SearchSensor sensor) {
    switch (sensor) {
        case SearchSensor::Camera:
            return "camera";
        case SearchSensor::Infrared:
            return "infrared";
        case SearchSensor::Scanner:
            break;
    }
    return "scanner";
}

bool SearchField::holds(const Eigen::Vector3d& point) const {
    if (outer > 0.0) {
        const double angle = std::atan2(point.head<2>().norm(), point.z());
        return angle >= inner && angle <= outer;
    }
    if (!(point.z() > 0.0)) return false;
    const double across = point.x() / point.z(), along = point.y() / point.z();
    return across >= left && across <= right && along >= up && along <= down;
}

double SearchField::halfAngle() const {
    if (outer > 0.0) return outer;
    return std::atan(std::hypot(std::max(-left, right), std::max(-up, down)));
}

std::optional<SearchField> fieldOf(const CameraInfoSample& camera) {
    if (camera.width <= 0 || camera.height <= 0) return std::nullopt;
    const double width = camera.width, height = camera.height;
    const auto look = [&](double x, double y) {
        return pixelDirection(camera, {x, y}, camera.width, camera.height);
    };
    const auto left = look(0.0, height / 2), right = look(width - 1, height / 2), up = look(width / 2, 0.0),
               down = look(width / 2, height - 1);
    if (isFisheye(camera) || !left || !right || !up || !down) return ringOf(camera);
    for (const auto& side : {*left, *right, *up, *down}) {
        if (!side.allFinite() || !(side.z() > 1e-3)) return std::nullopt;
    }
    SearchField field;
    field.left = left->x() / left->z();
    field.right = right->x() / right->z();
    field.up = up->y() / up->z();
    field.down = down->y() / down->z();
    field.pixelsPerRadian = camera.intrinsics[0];
    if (!(field.left < field.right) || !(field.up < field.down) || !(field.pixelsPerRadian > 0.0))
        return std::nullopt;
    return field;
}

double SearchView::range(const CoverageSettings& settings) const {
    const bool infrared = sensor == SearchSensor::Infrared;
    const double pixels = infrared ? settings.infraredPixels : settings.cameraPixels;
    const double reach = infrared ? settings.infraredReach : settings.cameraReach;
    if (!(pixels > 0.0)) return reach;
    return std::min(reach, settings.bodySide * field.pixelsPerRadian / pixels);
}

}  // namespace leitstand
