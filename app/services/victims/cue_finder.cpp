#include "app/services/victims/cue_finder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/base/time.h"
#include "core/event/cloud_sample.h"
#include "core/event/motion_samples.h"
#include "core/event/picture_samples.h"
#include "core/event/status_samples.h"
#include "core/event/stream_role.h"
#include "core/perception/cues/hazard.h"
#include "core/perception/heat/body_heat.h"
#include "core/perception/heat/heat.h"
#include "core/perception/omni/mei_camera.h"
#include "core/perception/pictures/content_hash.h"

namespace leitstand {
namespace {

constexpr double Still = 0.012;          // slower is standing [m/s, rad/s]
constexpr double StillCamera = 0.004;    // turned less between two pictures [rad]
constexpr std::size_t MostWaiting = 60;  // pictures and slices
constexpr double StampJitter = 0.02;     // between a picture and its reported angles [s]
constexpr double UnknownPlace = 0.35;    // of a sighting without a deviation [m]

double angleOf(const CameraInfoSample& camera, double pixels, int width) {
    const double scale = camera.width > 0 && width > 0 ? static_cast<double>(camera.width) / width : 1.0;
    return camera.intrinsics[0] > 0.0 ? pixels * scale / camera.intrinsics[0] : 0.05;
}

/// Whether @p pixel of @p picture is in the box of @p blob and as warm as it.
bool isWarm(const ThermalPicture& picture, const Eigen::Vector2d& pixel, const HeatBlob& blob) {
    const double x = std::floor(pixel.x()), y = std::floor(pixel.y());
    if (x < blob.left || x > blob.right || y < blob.top || y > blob.bottom) return false;
    const auto place =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
    return static_cast<double>(picture.celsius[place]) >= HeatSettings{}.coolest;
}

}  // namespace

CueFinder::CueFinder(const RobotDescription& robot, const CueSettings& settings)
    : m_robot(robot), m_settings(settings), m_places(m_robot), m_seen({robot.footprint, robot.height}) {}

std::vector<PlacedCue> CueFinder::found() {
    return std::exchange(m_found, {});
}

Cue CueFinder::cueOf(const Event& event, const char* kind, Time stamp) const {
    Cue cue;
    cue.kind = kind;
    cue.robot = m_robot.name;
    cue.sensor = event.sensor;
    cue.topic = event.topic;
    cue.sequence = event.sequence;
    cue.stamp = stamp;
    return cue;
}

void CueFinder::onEvent(const Event& event) {
    m_places.onEvent(event);
    if (const auto* odometry = event.sample.as<OdometrySample>()) {
        if (odometry->linear.norm() > Still || odometry->angular.norm() > 3.0 * Still)
            m_movedAt = stampOf(event, odometry->header);
        if (m_notReceived) {
            const Event late = *m_notReceived;
            receive(late, late.sample.get<SightingSample>());
        }
        look(event.received);
    } else if (const auto* cloud = event.sample.as<CloudSample>()) {
        const auto sensor = m_places.inBase(event.sensor, cloud->header.frame, cloud->header.stamp);
        if (sensor && m_slices.size() < MostWaiting) m_slices.emplace_back(event, *sensor);
    } else if (const auto* ranges = event.sample.as<RangesSample>()) {
        const auto sensor = m_places.inBase(event.sensor, ranges->header.frame, ranges->header.stamp);
        if (sensor && m_slices.size() < MostWaiting) m_slices.emplace_back(event, *sensor);
    } else if (const auto* info = event.sample.as<CameraInfoSample>()) {
        m_cameras[event.sensor].info = *info;
    } else if (event.sample.is<PictureSample>()) {
        if (m_waiting.size() < MostWaiting) m_waiting.push_back(event);
    } else if (const auto* gas = event.sample.as<GasSample>()) {
        smell(event, *gas);
    } else if (const auto* sightings = event.sample.as<SightingSample>()) {
        receive(event, *sightings);
    }
}

void CueFinder::look(Time now) {
    const auto base = [this](Time at) { return m_places.baseInOdom(at); };
    const auto waits = [&](const Event& event, Time stamp) {
        return !m_places.covers(stamp) && now - event.received < m_settings.longestWait;
    };
    while (!m_slices.empty()) {
        const auto& [event, sensor] = m_slices.front();
        if (const auto* cloud = event.sample.as<CloudSample>()) {
            const std::int64_t last = cloud->times.empty() ? 0 : cloud->times.back();
            if (waits(event, cloud->header.stamp + std::chrono::nanoseconds(last))) break;
            m_seen.add(*cloud, sensor, base);
        } else {
            const auto& ranges = event.sample.get<RangesSample>();
            if (waits(event, ranges.header.stamp)) break;
            m_seen.add(ranges, sensor, base);
        }
        m_slices.pop_front();
    }
    while (!m_waiting.empty()) {
        const Event& event = m_waiting.front();
        if (waits(event, stampOf(event, event.sample.get<PictureSample>().header))) break;
        look(event);
        m_waiting.pop_front();
    }
}

std::optional<CueFinder::View> CueFinder::viewOf(const Event& event, const PictureSample& picture,
                                                 Camera& camera) {
    const Time stamp = stampOf(event, picture.header);
    const auto place = m_places.at(event.sensor, picture.header.frame, stamp);
    if (!place) return std::nullopt;
    const Pose& inBase = place->sensorInBase;
    View view;
    if (camera.before && stamp + std::chrono::seconds(5) < camera.beforeAt) {  // the robot's clock restarted
        camera.before.reset();
        m_movedAt = std::min(m_movedAt, stamp);
    }
    if (camera.before) {
        const double since = std::max(1e-3, secondsBetween(camera.beforeAt, stamp));
        const double turned = angleBetween(*camera.before, inBase);
        view.turning = turned / since;
        if (turned > StillCamera) camera.stoodSince = stamp;
    } else {
        camera.stoodSince = stamp;
    }
    camera.before = inBase;
    camera.beforeAt = stamp;
    camera.stoodSince = std::max(camera.stoodSince, m_movedAt);
    if (!place->baseInMap) return std::nullopt;
    view.opticalInOdom = place->sensorInOdom();
    view.opticalInMap = *place->baseInMap * inBase;
    view.baseInMap = *place->baseInMap;
    view.certain = place->certain;
    return view;
}

void CueFinder::look(const Event& event) {
    const auto& sample = event.sample.get<PictureSample>();
    Camera& camera = m_cameras[event.sensor];
    const auto view = viewOf(event, sample, camera);
    if (!view || !camera.info || view->turning > m_settings.fastest) {
        camera.motion.moved();
        return;
    }
    if (event.role == StreamRole::Thermal) return lookForHeat(event, camera, *view);
    if (event.role != StreamRole::Picture) return;
    // Omnidirectional pictures are too coarse for this search.
    const Eigen::Vector2d middle(0.5 * camera.info->width, 0.5 * camera.info->height);
    if (!pixelDirection(*camera.info, middle, camera.info->width, camera.info->height)) return;
    const Time stamp = stampOf(event, sample.header);
    const bool still = secondsBetween(camera.stoodSince, stamp) > m_settings.standing;
    if (!still) camera.motion.moved();
    const bool compare = still && stamp - camera.compared >= m_settings.motionEvery;
    const bool read = stamp - camera.read >= m_settings.signsEvery || stamp < camera.read;
    if (!compare && !read) return;
    const auto picture = camera.decoder.decode(sample);
    if (!picture) return;  // whoever looks at it is notified
    if (compare || stamp < camera.compared) {
        camera.compared = stamp;
        lookForMotion(event, camera, *view, *picture);
    }
    if (read) {
        camera.read = stamp;
        lookForSigns(event, camera, *view, *picture);
    }
}

std::optional<RayHit> CueFinder::meet(const View& view, const Eigen::Vector3d& direction, double halfAngle,
                                      double farthest, const SeenPoints::Shows& shows) const {
    return m_seen.meet(rayFrom(view.opticalInOdom, direction), halfAngle, farthest, shows);
}

void CueFinder::keep(PlacedCue cue, const View& view) {
    const double height = cue.inMap.z() - view.baseInMap.translation().z();
    if (height > m_settings.highest && cue.what == FindSample::Kind::Victim) return;
    if (height < m_settings.lowest) return;
    m_found.push_back(std::move(cue));
}

bool CueFinder::place(PlacedCue cue, const Camera& camera, const View& view, const Eigen::Vector2d& pixel,
                      int width, int height, double halfAngle, double farthest) {
    const auto direction = pixelDirection(*camera.info, pixel, width, height);
    if (!direction) return false;
    const auto hit = meet(view, *direction, halfAngle, farthest);
    if (!hit) return false;
    placeByRay(cue, rayFrom(view.opticalInMap, *direction), *hit, halfAngle + StampJitter * view.turning,
               view.certain);
    keep(std::move(cue), view);
    return true;
}

std::optional<PlacedCue> CueFinder::locate(const LookedAt& looked) {
    constexpr double Farthest = 9.0;  // [m]
    const auto* sample = looked.picture.sample.as<PictureSample>();
    const auto camera = m_cameras.find(looked.picture.sensor);
    if (sample == nullptr || camera == m_cameras.end() || !camera->second.info) return std::nullopt;
    const auto mirror = MeiCamera::of(*camera->second.info, looked.width, looked.height);
    const Eigen::Vector2d middle(0.5, 0.5);  // the mirror's model counts from the middle of the first pixel
    const auto direction =
        mirror ? mirror->direction(looked.pixel - middle)
               : pixelDirection(*camera->second.info, looked.pixel, looked.width, looked.height);
    const Time stamp = stampOf(looked.picture, sample->header);
    const auto place = m_places.at(looked.picture.sensor, sample->header.frame, stamp);
    if (!direction || !place || !place->baseInMap) return std::nullopt;
    const auto hit = m_seen.meet(rayFrom(place->sensorInOdom(), *direction), looked.halfAngle, Farthest);
    if (!hit) return std::nullopt;
    PlacedCue cue;
    cue.cue = cueOf(looked.picture, "operator", stamp);
    placeByRay(cue, rayFrom(*place->baseInMap * place->sensorInBase, *direction), *hit, looked.halfAngle,
               place->certain);
    return cue;
}

bool CueFinder::shows(const Event& picture, const Eigen::Vector3d& inMap) {
    constexpr double Beam = degrees(2.0);  // half angle
    constexpr double Thick = 0.6;          // points this near before the place belong to it [m]
    const auto* sample = picture.sample.as<PictureSample>();
    const auto camera = m_cameras.find(picture.sensor);
    if (sample == nullptr || camera == m_cameras.end() || !camera->second.info) return false;
    const CameraInfoSample& info = *camera->second.info;
    const int width = static_cast<int>(info.width), height = static_cast<int>(info.height);
    const auto place = m_places.at(picture.sensor, sample->header.frame, stampOf(picture, sample->header));
    if (!place || !place->baseInMap) return false;
    const Eigen::Vector3d inCamera = (*place->baseInMap * place->sensorInBase).inverse() * inMap;
    const double range = inCamera.norm();
    const auto pixel = pixelOf(info, inCamera, width, height);
    const bool within = pixel && pixel->minCoeff() >= 0.0 && pixel->x() < width && pixel->y() < height;
    if (!within || !(range <= m_settings.farthestHeat)) return false;
    const auto hit =
        m_seen.meet(rayFrom(place->sensorInOdom(), inCamera / range), Beam, m_settings.farthestHeat);
    return !hit || hit->range > range - Thick;
}

void CueFinder::lookForHeat(const Event& event, Camera& camera, const View& view) {
    const StreamDescription* stream = m_robot.stream(StreamRole::Thermal, event.sensor);
    if (stream == nullptr || !stream->thermal.measured) return;
    const auto& sample = event.sample.get<PictureSample>();
    const auto picture = camera.decoder.decode(sample);
    if (!picture) return;
    const auto thermal = temperatures(*picture, stream->thermal);
    if (!thermal) return;
    for (const HeatBlob& blob : findHeat(*thermal, *camera.info)) {
        if (blob.kind != HeatBlob::Kind::Body) break;  // bodies come first
        const auto direction = pixelDirection(*camera.info, blob.centre, thermal->width, thermal->height);
        if (!direction) continue;
        // Only points on warm pixels count: beside a head is a wall.
        const Eigen::Matrix3d odomInOptical = view.opticalInOdom.linear().transpose();
        const auto shows = [&](const Eigen::Vector3d& inOdom) {
            const auto pixel = pixelOf(*camera.info, odomInOptical * inOdom, thermal->width, thermal->height);
            return pixel && isWarm(*thermal, *pixel, blob);
        };
        const double spread = std::max(degrees(2.5), 0.5 * std::max(blob.width, blob.height));
        const auto hit = meet(view, *direction, spread, m_settings.farthestHeat, shows);
        if (!hit) continue;
        const BodyHeat body = judgeBody(*thermal, blob, hit->range);
        PlacedCue cue;
        cue.cue = cueOf(event, "heat", stampOf(event, sample.header));
        cue.cue.value = blob.mean;
        cue.cue.confidence = body.likelihood * (0.6 + 0.4 * blob.confidence) * (blob.cut ? 0.7 : 1.0);
        placeByRay(cue, rayFrom(view.opticalInMap, *direction), *hit,
                   0.5 * blob.size + StampJitter * view.turning, view.certain);
        keep(std::move(cue), view);
    }
}

void CueFinder::lookForMotion(const Event& event, Camera& camera, const View& view, const Picture& picture) {
    const auto& sample = event.sample.get<PictureSample>();
    const Time stamp = stampOf(event, sample.header);
    for (const MotionBlob& blob : camera.motion.look(picture, stamp)) {
        PlacedCue cue;
        cue.cue = cueOf(event, "motion", stamp);
        cue.cue.value = cue.cue.confidence = blob.strength;
        const double half = angleOf(*camera.info, 0.25 * (blob.right - blob.left + 1), picture.width);
        (void)place(std::move(cue), camera, view, blob.centre, picture.width, picture.height,
                    std::max(degrees(2.0), half), m_settings.farthest);
    }
}

void CueFinder::lookForSigns(const Event& event, const Camera& camera, const View& view,
                             const Picture& picture) {
    const Time stamp = stampOf(event, event.sample.get<PictureSample>().header);
    for (const FoundCode& code : m_codes.read(picture)) {
        PlacedCue cue;
        cue.what = FindSample::Kind::Code;
        cue.cue = cueOf(event, "code", stamp);
        cue.cue.text = code.text;
        cue.cue.confidence = 0.95;
        const double half = std::max(degrees(2.0), angleOf(*camera.info, 0.5 * code.size, picture.width));
        (void)place(std::move(cue), camera, view, code.centre, picture.width, picture.height, half,
                    m_settings.farthest);
    }
    for (const HazardPlacard& sign : findHazards(picture)) {
        PlacedCue cue;
        cue.what = FindSample::Kind::Hazard;
        cue.cue = cueOf(event, "hazard", stamp);
        cue.cue.text = sign.name;
        cue.cue.confidence = sign.confidence;
        const double half = std::max(degrees(2.0), angleOf(*camera.info, 0.3 * sign.size, picture.width));
        (void)place(std::move(cue), camera, view, sign.centre, picture.width, picture.height, half,
                    m_settings.farthest);
    }
}

void CueFinder::smell(const Event& event, const GasSample& gas) {
    if (gas.gas != "co2") return;
    const Time stamp = stampOf(event, gas.header);
    const auto rise = m_gases[event.sensor].add(stamp, gas.ppm);
    const auto base = m_places.baseInMap(m_places.now().stamp);
    const auto sensor = m_places.inBase(event.sensor, gas.header.frame, stamp);
    if (!rise || !base || !sensor) return;
    PlacedCue cue;
    cue.cue = cueOf(event, "co2", stamp);
    cue.cue.value = gas.ppm;
    cue.cue.confidence = std::clamp(rise->rise() / 500.0, 0.35, 1.0);
    cue.inMap = *base * sensor->translation();
    cue.reach = std::clamp(breathReach(rise->rise()), 0.9, 1.8);
    m_found.push_back(std::move(cue));
}

void CueFinder::receive(const Event& event, const SightingSample& sightings) {
    const auto base = m_places.baseInMap(m_places.now().stamp);
    const auto inOdom = m_places.baseInOdom(m_places.now().stamp);
    if (!base || !inOdom) {
        m_notReceived = event;  // a robot sends them once
        return;
    }
    m_notReceived.reset();
    const Pose odomInMap = *base * inOdom->inverse();
    for (const Sighting& one : sightings.sightings) {
        const auto known = m_sightings.find(one.id);
        if (!one.position.allFinite()) continue;
        if (known != m_sightings.end() && known->second.position == one.position &&
            known->second.kind == one.kind && known->second.text == one.text)
            continue;
        m_sightings[one.id] = one;
        PlacedCue cue;
        cue.cue = cueOf(event, "sighting", stampOf(event, sightings.header));
        cue.cue.value = one.value;
        cue.cue.confidence = one.confidence;
        cue.cue.text = fmt::format("{} {}", one.kind, one.id);
        if (one.kind == "code" || one.kind == "hazard") {
            cue.what = one.kind == "code" ? FindSample::Kind::Code : FindSample::Kind::Hazard;
            cue.cue.kind = one.kind;
            cue.cue.text = one.text;
        }
        cue.inMap = odomInMap * one.position;
        const double deviation =
            std::isfinite(one.deviation) ? std::clamp(one.deviation, 0.1, 2.0) : UnknownPlace;
        cue.covariance = deviation * deviation * Eigen::Matrix3d::Identity();
        m_found.push_back(std::move(cue));
    }
}

}  // namespace leitstand
