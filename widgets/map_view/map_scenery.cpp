#include "widgets/map_view/map_scenery.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QWidget>

#include "widgets/map_view/camera/camera_moves.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds RestAfter(120);
/// A robot that stops usually drives on soon. A full picture begun then would be interrupted.
constexpr std::chrono::milliseconds FollowRestAfter(500);
/// Interval of pictures while the camera follows a robot.
constexpr std::chrono::milliseconds FollowEvery(90);
/// Longer than the interval of robot poses, which come 30 times a second.
constexpr std::chrono::milliseconds GlideEvery(50);

bool sameScans(const MapPtr& a, const MapPtr& b) {
    if (!a || !b) return a == b;
    return std::equal(a->scans.begin(), a->scans.end(), b->scans.begin(), b->scans.end(),
                      [](const MapScan& x, const MapScan& y) { return x.scan == y.scan; });
}

/// Whether @p now is so close to @p fitting that the camera need not move. A map that grows a little then
/// stands still.
bool isAlmost(const MapCamera& now, const MapCamera& fitting) {
    constexpr double Shift = 0.03, Larger = 0.03, Smaller = 0.1;  // shares of the distance
    const double further = fitting.distance / now.distance - 1.0;
    return (fitting.focus - now.focus).norm() < Shift * now.distance && further < Larger &&
           further > -Smaller;
}

}  // namespace

// Callbacks come from other threads. Both workers stop calling before this object is destroyed.
MapScenery::MapScenery(QWidget& view)
    : m_view(view),
      m_freeCamera{presetCamera(CameraPreset::Reset, MapLook::Points)},
      m_topCamera{presetCamera(CameraPreset::Reset, MapLook::Top)},
      m_renderer({.onPicture =
                      [this](MapPicture picture) {
                          QMetaObject::invokeMethod(
                              this, [this, picture = std::move(picture)] { takePicture(picture); },
                              Qt::QueuedConnection);
                      },
                  .onFailure =
                      [this](const std::string& why) {
                          QMetaObject::invokeMethod(
                              this, [this, why] { takeFailure(why); }, Qt::QueuedConnection);
                      }}),
      m_builder([this](SceneContentPtr content) {
          QMetaObject::invokeMethod(
              this, [this, content = std::move(content)] { takeContent(content); }, Qt::QueuedConnection);
      }) {
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] { draw(true); });
    m_followed.setSingleShot(true);
    m_followed.setInterval(FollowEvery);
    connect(&m_followed, &QTimer::timeout, this, [this] { drawFollowing(); });
    m_glide.setSingleShot(true);
    m_glide.setInterval(GlideEvery);
    connect(&m_glide, &QTimer::timeout, this, [this] { aim(m_robot); });
}

MapScenery::~MapScenery() = default;

void MapScenery::setMap(MapPtr map) {
    if (!sameScans(map, m_order.map)) m_freeCamera.due = m_topCamera.due = true;
    m_order.map = std::move(map);
    submit();
}

void MapScenery::setVisible(std::vector<bool> scanIsVisible) {
    m_order.scanIsVisible = std::move(scanIsVisible);
    submit();
}

void MapScenery::setTeam(std::vector<SceneRobot> robots) {
    if (robots == m_order.robots) return;
    m_order.robots = std::move(robots);
    // Only these colourings show robots' colours or names.
    const MapColouring by = m_order.settings.colouring;
    if (by == MapColouring::Robot || by == MapColouring::Scan) submit();
}

void MapScenery::setSettings(const MapViewSettings& settings) {
    if (settings == m_order.settings) return;
    const bool followed = following();
    const MapCamera camera = this->camera();
    const MapViewSettings former = std::exchange(m_order.settings, settings);
    const bool sameSide = (former.look == MapLook::Top) == (settings.look == MapLook::Top);
    if (former.follow != settings.follow || !sameSide) startFollowing();
    if (followed && settings.follow == MapFollow::Free && sameSide)
        activeCamera() = {camera, false, false, false};
    submit();
}

void MapScenery::recall(const MapViewSettings& settings) {
    if (settings == m_order.settings) return;
    const FramedCamera leftFree = m_freeCamera, leftTop = m_topCamera;
    setSettings(settings);
    m_freeCamera = leftFree;
    m_topCamera = leftTop;
    // The view may have been resized since.
    if (!following() && activeCamera().follows) frame();
}

void MapScenery::setHighlighted(std::uint64_t id) {
    if (id == m_order.highlighted) return;
    m_order.highlighted = id;
    submit();
}

void MapScenery::setGhosts(std::map<std::uint64_t, Pose> scansInMap, bool dragged) {
    const bool same = std::equal(scansInMap.begin(), scansInMap.end(), m_order.ghosts.begin(),
                                 m_order.ghosts.end(), [](const auto& a, const auto& b) {
                                     return a.first == b.first && a.second.matrix() == b.second.matrix();
                                 });
    if (same && dragged == m_order.dragged) return;
    m_order.dragged = dragged;
    m_order.ghosts = std::move(scansInMap);
    submit();
}

void MapScenery::setChanges(std::shared_ptr<const MapChanges> changes) {
    if (changes == m_order.changes) return;
    m_order.changes = std::move(changes);
    submit();
}

void MapScenery::startFollowing() {
    m_follow.start(m_order.settings.follow, m_order.settings.look == MapLook::Top);
    m_sinceAim.invalidate();
    m_glide.stop();
}

bool MapScenery::following() const {
    return m_order.settings.follow != MapFollow::Free && m_follow.aimed();
}

void MapScenery::aim(const Pose& baseInMap) {
    if (m_order.settings.follow == MapFollow::Free) return;
    const double seconds = m_sinceAim.isValid() ? static_cast<double>(m_sinceAim.nsecsElapsed()) / 1e9 : 0.0;
    m_sinceAim.start();
    m_robot = baseInMap;
    if (!m_follow.aim(baseInMap, seconds)) return m_glide.stop();
    m_glide.start();
    m_rest.start(FollowRestAfter);
    m_wentOn = true;
    if (!m_followed.isActive()) drawFollowing();
}

/// Draws at most once per FollowEvery, however often poses arrive.
void MapScenery::drawFollowing() {
    if (!std::exchange(m_wentOn, false)) return;
    m_followed.start();
    draw(false);
}

void MapScenery::stopFollowing() {
    MapViewSettings settings = m_order.settings;
    settings.follow = MapFollow::Free;
    setSettings(settings);
}

void MapScenery::frameScan(std::uint64_t id) {
    const auto scan = std::find_if(m_content->scans.begin(), m_content->scans.end(),
                                   [id](const SceneScan& one) { return one.id == id; });
    if (scan == m_content->scans.end() || !scan->points || scan->points->points.empty()) return;
    if (following()) stopFollowing();
    constexpr std::size_t Enough = 500;
    std::vector<Eigen::Vector3d> places;
    for (std::size_t i = 0; i < std::min(Enough, scan->points->points.size()); ++i)
        places.push_back(scan->poseInMap * scan->points->sample(i).cast<double>());
    moveCamera(framed(camera(), places, m_view.size()));
}

void MapScenery::centre(const Eigen::Vector3d& place) {
    if (following()) stopFollowing();
    MapCamera moved = camera();
    moved.focus = place;
    moveCamera(moved);
}

const MapCamera& MapScenery::camera() const {
    if (following()) return m_follow.camera();
    return m_order.settings.look == MapLook::Top ? m_topCamera.camera : m_freeCamera.camera;
}

MapScenery::FramedCamera& MapScenery::activeCamera() {
    return m_order.settings.look == MapLook::Top ? m_topCamera : m_freeCamera;
}

void MapScenery::moveCamera(const MapCamera& camera) {
    if (following()) {
        m_follow.adjust(camera);
    } else {
        activeCamera() = {camera, false, false, false};
    }
    draw(false);
    m_rest.start(RestAfter);
}

void MapScenery::setCamera(CameraPreset preset) {
    if (following()) stopFollowing();
    activeCamera() = {presetCamera(preset, m_order.settings.look), true, true, false};
    frame();
    draw(true);
}

void MapScenery::refresh() {
    if (!following() && activeCamera().follows) frame();
    if (!settled()) draw(true);
}

void MapScenery::frame() {
    FramedCamera& active = activeCamera();
    const MapCamera fitting = framed(active.camera, m_content->places, m_view.size());
    if (!active.fits || !isAlmost(active.camera, fitting)) active.camera = fitting;
    active.fits = true;
    active.due = !m_content->complete || m_content->order != m_order.number;
}

void MapScenery::finish() {
    takeContent(m_builder.finished());
    MapPicture picture = m_renderer.drawNow(drawOrder(true));
    if (!picture.image.isNull()) takePicture(std::move(picture));
}

MapProjection MapScenery::projection() const {
    return {m_picture.image.isNull() ? camera() : m_picture.order.camera, m_view.size()};
}

bool MapScenery::settled() const {
    return showsEverything(m_picture);
}

bool MapScenery::showsEverything(const MapPicture& picture) const {
    return picture.complete && picture.content->complete && picture.content->order == m_order.number &&
           picture.order == drawOrder(true);
}

DrawOrder MapScenery::drawOrder(bool full) const {
    return {camera(), m_view.size(), m_view.devicePixelRatioF(), full};
}

void MapScenery::submit() {
    ++m_order.number;
    m_wasSettled = false;
    m_builder.submit(m_order);
}

void MapScenery::takeContent(SceneContentPtr content) {
    if (content->order < m_content->order || (content->order == m_content->order && m_content->complete)) {
        return;  // overtaken by finish()
    }
    m_content = std::move(content);
    m_renderer.setContent(m_content);
    if (!following() && activeCamera().follows && activeCamera().due) frame();
    draw(!m_rest.isActive());
}

void MapScenery::takePicture(MapPicture picture) {
    const bool everything = showsEverything(picture);
    if (settled() && !everything) return;  // overtaken by finish()
    m_picture = std::move(picture);
    emit pictureChanged();
    if (everything && !std::exchange(m_wasSettled, true)) emit becameSettled();
}

void MapScenery::takeFailure(const std::string& why) {
    m_failure = tr("The map cannot be drawn: %1").arg(QString::fromStdString(why));
    emit failed(m_failure);
}

void MapScenery::draw(bool full) {
    if (!settled()) m_wasSettled = false;
    if (m_view.isVisible()) m_renderer.draw(drawOrder(full));
}

}  // namespace leitstand
