#include "app/window/panes/camera/camera_overlays.h"

#include <cmath>
#include <numbers>
#include <variant>

#include <QCoreApplication>

#include "core/perception/omni/panorama.h"
#include "core/perception/pictures/pixel_ray.h"
#include "widgets/models/live/robots/drive_state.h"

namespace leitstand {
namespace {

constexpr double UsualAngle = degrees(60);  ///< view of uncalibrated cameras, across [rad]

struct OverlayTexts {
    Q_DECLARE_TR_FUNCTIONS(leitstand::CameraPane)
};

double viewAngleOf(const ShownPicture& picture) {
    const Eigen::Vector3d left = directionAt(picture, {0.0, 0.5}), right = directionAt(picture, {1.0, 0.5});
    return std::acos(std::clamp(left.dot(right), -1.0, 1.0));
}

}  // namespace

bool isOmni(const ShownPicture* picture) {
    return picture != nullptr && picture->camera && picture->camera->distortionModel == "mei";
}

Eigen::Vector3d directionAt(const ShownPicture& picture, const QPointF& place) {
    const Eigen::Vector2d pixel(place.x() * picture.width, place.y() * picture.height);
    if (picture.camera) {
        if (const auto seen = pixelDirection(*picture.camera, pixel, picture.width, picture.height))
            return *seen;
    }
    const double focal = 0.5 * picture.width / std::tan(0.5 * UsualAngle);
    return Eigen::Vector3d(pixel.x() - 0.5 * picture.width, pixel.y() - 0.5 * picture.height, focal)
        .normalized();
}

std::optional<Eigen::Vector2d> rawPlace(const RobotDescription& robot, const ShownPicture& picture,
                                        const QPointF& place) {
    if (!picture.panorama) return Eigen::Vector2d(place.x(), place.y());
    const auto sensor = robot.sensors.find(picture.sensor);
    if (sensor == robot.sensors.end() || !picture.camera) return std::nullopt;
    const PanoramaShape& shape = *picture.panorama;
    return rawPlaceOf(*picture.camera, sensor->second.sensorInBase, shape.yawAt(place.x() * shape.width),
                      picture.width, picture.height, shape.elevationAt(place.y() * shape.height));
}

std::optional<QPointF> frontIn(const RobotDescription& robot, const ShownPicture& picture) {
    const auto sensor = robot.sensors.find(picture.sensor);
    if (!isOmni(&picture) || picture.panorama || sensor == robot.sensors.end()) return std::nullopt;
    const auto place =
        rawPlaceOf(*picture.camera, sensor->second.sensorInBase, 0.0, picture.width, picture.height);
    if (!place) return std::nullopt;
    return QPointF(place->x(), place->y());
}

CameraOverlay cameraOverlay(const std::optional<CameraTurn>& turn, const ShownPicture* picture,
                            bool autoRange, const CameraKeyNames& keys) {
    CameraOverlay overlay;
    if (turn) {
        const PanTiltAngles now = turn->now.value_or(PanTiltAngles{});
        if (turn->now) overlay.turn.pan = now.pan, overlay.turn.tilt = now.tilt;
        if (turn->requested) overlay.requestedPan = turn->requested->pan;
        overlay.turn.keys = keys.turn;
        overlay.turn.recentreKey = keys.recentre;
        overlay.turn.waiting = turn->waiting;
        overlay.turn.heldBy = QString::fromStdString(turn->heldBy);
        overlay.panLimit = turn->mount.pan;
    }
    if (picture == nullptr) return overlay;
    if (!isOmni(picture) && picture->width > 0) overlay.viewAngle = viewAngleOf(*picture);
    if (const QString raised = contrastText(picture->contrast); !raised.isEmpty()) overlay.notes << raised;
    if (autoRange && std::holds_alternative<ThermalPicture>(picture->content))
        overlay.notes << OverlayTexts::tr("colours follow the picture");
    return overlay;
}

void addDriving(CameraOverlay& overlay, const RobotDescription& robot, const LiveMoment& moment,
                const ShownPicture* picture) {
    const RobotView& view = moment.view(robot.name);
    const RobotState& reported = moment.reported(robot.name);
    overlay.mode = modeLabelOf(view, reported.mode);
    const auto attitude = rollAndPitch(robot, reported, moment.now);
    if (attitude && !isOmni(picture)) {
        overlay.roll = attitude->first;
        overlay.pitch = attitude->second;
    }
    if (view.around)
        overlay.ring = proximityRing(*view.around, boxAround(robot.footprint), view.drive.velocity);
    overlay.moving = !isZero(view.drive.velocity);
}

void addDetections(CameraOverlay& overlay, const RobotDescription& robot, const LiveMoment& moment,
                   const ShownPicture* picture) {
    if (picture == nullptr || picture->panorama) return;
    overlay.detections = detectionMarks(robot, moment.reported(robot.name),
                                        {picture->sensor, picture->sample.header.frame, picture->stamp,
                                         picture->received, picture->width, picture->height});
}

}  // namespace leitstand
