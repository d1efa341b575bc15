#include "widgets/map_view/map_scenery.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QWidget>

#include "widgets/map_view/camera_moves.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds RestAfter(120);

bool sameScans(const MapPtr& a, const MapPtr& b) {
    if (!a || !b) return a == b;
    return std::equal(a->scans.begin(), a->scans.end(), b->scans.begin(), b->scans.end(),
                      [](const MapScan& x, const MapScan& y) { return x.scan == y.scan; });
}

}  // namespace

// Callbacks come from other threads while this object lives: both workers stop calling before it goes.
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
    m_rest.setInterval(RestAfter);
    connect(&m_rest, &QTimer::timeout, this, [this] { draw(true); });
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

void MapScenery::setSettings(const MapViewSettings& settings) {
    if (settings == m_order.settings) return;
    m_order.settings = settings;
    submit();
}

const MapCamera& MapScenery::camera() const {
    return m_order.settings.look == MapLook::Top ? m_topCamera.camera : m_freeCamera.camera;
}

MapScenery::FramedCamera& MapScenery::activeCamera() {
    return m_order.settings.look == MapLook::Top ? m_topCamera : m_freeCamera;
}

void MapScenery::moveCamera(const MapCamera& camera) {
    activeCamera() = {camera, false, false};
    draw(false);
    m_rest.start();
}

void MapScenery::setCamera(CameraPreset preset) {
    activeCamera() = {presetCamera(preset, m_order.settings.look), true, true};
    frame();
    draw(true);
}

void MapScenery::refresh() {
    if (activeCamera().follows) frame();
    if (!settled()) draw(true);
}

void MapScenery::frame() {
    FramedCamera& active = activeCamera();
    active.camera = framed(active.camera, m_content->places, m_view.size());
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
    if (activeCamera().follows && activeCamera().due) frame();
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
