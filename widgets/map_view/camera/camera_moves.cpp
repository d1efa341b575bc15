#include "widgets/map_view/camera/camera_moves.h"

#include <algorithm>
#include <cmath>

#include "core/base/pose.h"

namespace leitstand {
namespace {

constexpr double RadiansPerPixel = 0.006;
constexpr double Nearest = 0.2, Farthest = 2000.0;  ///< distances of the eye from the focus [m]

}  // namespace

MapCamera turned(MapCamera camera, const QPointF& pixels) {
    camera.yaw = std::remainder(camera.yaw - RadiansPerPixel * pixels.x(), degrees(360));
    if (!camera.parallel) {
        camera.pitch = std::clamp(camera.pitch + RadiansPerPixel * pixels.y(), degrees(-90), degrees(90));
    }
    return camera;
}

MapCamera shifted(const MapProjection& projection, const QPointF& pixels, double depth) {
    MapCamera camera = projection.camera();
    const double scale = projection.metresPerPixel(depth);
    camera.focus += scale * (pixels.y() * camera.up() - pixels.x() * camera.right());
    return camera;
}

MapCamera zoomed(const MapProjection& projection, const QPointF& position, double depth, double factor) {
    MapCamera camera = projection.camera();
    const double allowed = std::clamp(factor, Nearest / camera.distance, Farthest / camera.distance);
    const Eigen::Vector3d fixed = projection.unproject(position, depth);
    camera.focus = fixed + allowed * (camera.focus - fixed);
    camera.distance *= allowed;
    return camera;
}

MapCamera presetCamera(CameraPreset preset, MapLook look) {
    MapCamera camera;
    if (look == MapLook::Top || preset == CameraPreset::Top) {
        camera.yaw = 0.0;
        camera.pitch = degrees(90);
        camera.parallel = look == MapLook::Top;
    } else if (preset == CameraPreset::Side) {
        camera.yaw = degrees(90);
        camera.pitch = 0.0;
    } else {
        camera.yaw = degrees(35);
        camera.pitch = degrees(30);
    }
    return camera;
}

}  // namespace leitstand
