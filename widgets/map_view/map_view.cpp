#include "widgets/map_view/map_view.h"

#include <algorithm>
#include <utility>

#include <QPainter>

#include "widgets/map_view/map_view_state.h"
#include "widgets/map_view/overlays/floor_overlay.h"
#include "widgets/map_view/overlays/hint.h"
#include "widgets/map_view/overlays/legend.h"
#include "widgets/map_view/overlays/map_marks.h"
#include "widgets/map_view/overlays/scale_overlays.h"
#include "widgets/map_view/overlays/scan_outlines.h"
#include "widgets/map_view/picking.h"
#include "widgets/map_view/robots/robot_overlay.h"
#include "widgets/map_view/victims/victim_overlay.h"
#include "widgets/painting/theme.h"

namespace leitstand {
namespace {

constexpr double StaleVeil = 0.5;  ///< opacity of the background over a stale map

void paintFailure(QPainter& painter, const QRect& area, const QString& why, const OverlayStyle& style) {
    painter.setFont(style.font);
    painter.setPen(asColour(style.colours.text));
    painter.drawText(area.adjusted(24, 24, -24, -24), Qt::AlignCenter | Qt::TextWordWrap, why);
}

}  // namespace

MapView::MapView(QWidget* parent) : QWidget(parent), m_state(std::make_unique<State>(*this)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setMinimumSize(160, 120);
    setAccessibleName(tr("3D map"));
    MapScenery& scenery = m_state->scenery;
    connect(&scenery, &MapScenery::pictureChanged, this, qOverload<>(&QWidget::update));
    connect(&scenery, &MapScenery::pictureChanged, this, &MapView::drawn);
    connect(&scenery, &MapScenery::becameSettled, this, &MapView::becameSettled);
    connect(&scenery, &MapScenery::failed, this, [this](const QString& why) {
        update();
        emit failed(why);
    });
    connect(&m_state->hover, &QTimer::timeout, this, [this] { emit hovered(pick(m_state->cursor)); });
}

MapView::~MapView() = default;

void MapView::setMap(MapPtr map) {
    m_state->scenery.setMap(std::move(map));
}

void MapView::setVisible(std::vector<bool> scanIsVisible) {
    m_state->scenery.setVisible(std::move(scanIsVisible));
}

void MapView::setSettings(const MapViewSettings& settings) {
    m_state->scenery.setSettings(settings);
    update();
}

void MapView::recall(const MapViewSettings& settings) {
    m_state->scenery.recall(settings);
    for (const RobotMark& robot : m_state->robots) {
        if (robot.selected) m_state->scenery.aim(robot.baseInMap);
    }
    update();
}

const MapViewSettings& MapView::settings() const {
    return m_state->scenery.settings();
}

void MapView::setCamera(CameraPreset preset) {
    const bool following = m_state->scenery.following();
    m_state->scenery.setCamera(preset);
    if (following && !m_state->scenery.following()) emit followEnded();
}

void MapView::setHighlighted(std::uint64_t id) {
    m_state->highlighted = id;
    m_state->scenery.setHighlighted(id);
    update();
}

void MapView::setChanges(std::shared_ptr<const MapChanges> changes) {
    m_state->scenery.setChanges(std::move(changes));
}

void MapView::setGhosts(std::map<std::uint64_t, Pose> scansInMap) {
    m_state->ghosts = std::move(scansInMap);
    m_state->showGhosts();
}

void MapView::setDragged(std::map<std::uint64_t, Pose> scansInMap) {
    m_state->draggedScans = std::move(scansInMap);
    m_state->showGhosts();
}

void MapView::State::showGhosts() {
    const bool drags = !draggedScans.empty();
    scenery.setGhosts(drags ? draggedScans : ghosts, drags);
}

void MapView::showScan(std::uint64_t id) {
    const bool following = m_state->scenery.following();
    m_state->scenery.frameScan(id);
    if (following && !m_state->scenery.following()) emit followEnded();
}

void MapView::showPlace(const Eigen::Vector3d& place) {
    const bool following = m_state->scenery.following();
    m_state->scenery.centre(place);
    if (following && !m_state->scenery.following()) emit followEnded();
}

void MapView::setFloorTint(FloorTintPtr tint) {
    m_state->floor.setTint(std::move(tint));
    update();
}

void MapView::setMeasuring(bool on) {
    m_state->measuring = on;
    m_state->ruler.clear();
    setCursor(on ? Qt::CrossCursor : Qt::ArrowCursor);
    update();
}

std::optional<Measurement> MapView::measurement() const {
    const SceneContentPtr& content = m_state->scenery.picture().content;
    return content ? m_state->ruler.measurement(*content) : std::nullopt;
}

std::optional<PickedPoint> MapView::pick(const QPoint& position) const {
    const MapScenery& scenery = m_state->scenery;
    if (!scenery.picture().content) return std::nullopt;
    return pickPoint(*scenery.picture().content, scenery.projection(), QPointF(position));
}

std::optional<QPointF> MapView::project(const Eigen::Vector3d& pointInMap) const {
    const auto projected = m_state->scenery.projection().project(pointInMap);
    if (!projected) return std::nullopt;
    return projected->position;
}

QImage MapView::picture() {
    MapScenery& scenery = m_state->scenery;
    scenery.finish();
    QImage image = scenery.picture().image;
    if (image.isNull()) return image;
    QPainter painter(&image);
    m_state->paintOverlays(painter);
    return image;
}

bool MapView::settled() const {
    return m_state->scenery.settled();
}

bool MapView::showsScans() const {
    const MapPicture& picture = m_state->scenery.picture();
    if (picture.image.isNull()) return false;
    const std::vector<SceneScan>& scans = picture.content->scans;
    return std::any_of(scans.begin(), scans.end(),
                       [](const SceneScan& one) { return one.points && !one.points->points.empty(); });
}

void MapView::paintEvent(QPaintEvent* /*event*/) {
    const MapScenery& scenery = m_state->scenery;
    QPainter painter(this);
    if (scenery.picture().image.isNull()) {
        const OverlayStyle style = m_state->style(scenery.settings().theme);
        painter.fillRect(rect(), asColour(style.colours.background));
        if (!scenery.failure().isEmpty()) paintFailure(painter, rect(), scenery.failure(), style);
        return;
    }
    painter.drawImage(rect(), scenery.picture().image);
    if (m_state->stale) {
        QColor veil = asColour(mapColours(scenery.settings().theme).background);
        veil.setAlphaF(StaleVeil);
        painter.fillRect(rect(), veil);
    }
    m_state->paintOverlays(painter);
}

void MapView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_state->scenery.refresh();
}

void MapView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_state->scenery.refresh();
}

MapView::State::State(MapView& mapView) : view(mapView), scenery(mapView) {
    hover.setSingleShot(true);
    hover.setInterval(HoverInterval);
}

OverlayStyle MapView::State::style(Theme theme) const {
    return {mapColours(theme), &coloursOf(theme), view.font(), view.locale()};
}

void MapView::State::paintOverlays(QPainter& painter) {
    const SceneContent& content = *scenery.picture().content;
    if (content.scans.empty() && robots.empty()) return;
    const MapProjection projection = scenery.projection();
    const OverlayStyle overlay = style(content.settings.theme);
    painter.setRenderHint(QPainter::Antialiasing);
    double gridStep = 0.0;
    if (content.settings.look == MapLook::Top) {
        gridStep = paintGroundGrid(painter, projection, content, overlay);
    }
    floor.paint(painter, projection, overlay);
    paintScanOutlines(painter, projection, content, overlay);
    const bool trails = std::any_of(robots.begin(), robots.end(), [](const auto& one) { return one.trail; });
    paintScanPositions(painter, projection, content, !trails, overlay);
    paintLinks(painter, projection, content, links, overlay);
    if (highlighted != 0) paintHighlight(painter, projection, content, highlighted, overlay);
    paintArea(painter, projection, area, ground, overlay);
    paintTrails(painter, projection, robots, overlay);
    paintRobots(painter, projection, robots, overlay);
    paintVictims(painter, projection, finds, chosenFind, overlay);
    tools.paint(painter, projection, overlay);
    if (content.settings.follow == MapFollow::Free) {
        for (const MapCaption& caption : captions)
            paintCaption(painter, projection, caption.places, caption.text, overlay);
    }
    if (seam) paintMeasurement(painter, projection, seam->from, seam->to, overlay);
    if (const auto from = ruler.from(content))
        paintMeasurement(painter, projection, *from, ruler.to(content), overlay);
    const QRect scaleBar = paintScaleBar(painter, projection, gridStep, overlay);
    const QRect legend = paintLegend(painter, content, projection.size(), scaleBar, overlay);
    if (floor.tint()) paintFloorLegend(painter, *floor.tint(), projection.size(), legend, overlay);
    paintAxes(painter, projection, overlay);
    if (!hint.isEmpty()) paintHint(painter, hint, projection.size(), overlay);
}

}  // namespace leitstand
