#include "widgets/map_view/map_view.h"

#include <algorithm>
#include <utility>

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QRegularExpression>
#include <QToolTip>
#include <QWheelEvent>

#include "widgets/map_view/map_overlay.h"
#include "widgets/map_view/map_pointer.h"
#include "widgets/map_view/map_scenery.h"
#include "widgets/map_view/picking.h"
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

struct MapView::State {
    explicit State(MapView& mapView) : view(mapView), scenery(mapView), pointer(mapView, scenery, overlay) {}

    [[nodiscard]] OverlayStyle style(Theme theme) const {
        return {mapColours(theme), &coloursOf(theme), view.font(), view.locale()};
    }
    void paintOverlay(QPainter& painter) {
        const SceneContent& content = *scenery.picture().content;
        overlay.paint(painter, scenery.projection(), content, style(content.settings.theme));
    }
    void describe();  ///< updates the text for screen readers
    void showGhosts();

    MapView& view;
    MapScenery scenery;
    MapOverlay overlay;
    MapPointer pointer;
    std::map<std::uint64_t, Pose> ghosts, draggedScans;  ///< setGhosts(), setDragged()
    bool stale = false;                                  ///< the map is greyed
};

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
    for (const RobotMark& robot : m_state->overlay.robots) {
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
    m_state->overlay.highlighted = id;
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
    m_state->overlay.floor.setTint(std::move(tint));
    update();
}

void MapView::setGrid(std::optional<RobotGrid> grid) {
    if (m_state->overlay.grid.setGrid(std::move(grid))) update();
}

void MapView::setMeasuring(bool on) {
    m_state->pointer.setMeasuring(on);
}

std::optional<Measurement> MapView::measurement() const {
    const SceneContentPtr& content = m_state->scenery.picture().content;
    return content ? m_state->overlay.ruler.measurement(*content) : std::nullopt;
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
    m_state->paintOverlay(painter);
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
    m_state->paintOverlay(painter);
}

void MapView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    m_state->scenery.refresh();
}

void MapView::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    m_state->scenery.refresh();
}

void MapView::setRobots(std::vector<RobotMark> robots) {
    for (const RobotMark& robot : robots) {
        if (robot.selected) m_state->scenery.aim(robot.baseInMap);
    }
    const bool same = std::equal(robots.begin(), robots.end(), m_state->overlay.robots.begin(),
                                 m_state->overlay.robots.end(), sameMark);
    m_state->overlay.robots = std::move(robots);
    m_state->describe();
    if (same) return;
    std::vector<SceneRobot> team;
    for (const RobotMark& robot : m_state->overlay.robots)
        team.push_back({robot.face.name.toStdString(), robot.face.title.toStdString(), robot.face.place,
                        robot.face.letter.toStdString()});
    m_state->scenery.setTeam(std::move(team));
    update();
}

void MapView::setFinds(std::vector<VictimRow> finds, const std::optional<FindKey>& chosen) {
    if (finds == m_state->overlay.finds && chosen == m_state->overlay.chosenFind) return;
    m_state->overlay.finds = std::move(finds);
    m_state->overlay.chosenFind = chosen;
    update();
}

void MapView::setStale(bool stale) {
    if (std::exchange(m_state->stale, stale) != stale) update();
}

void MapView::setArea(std::vector<Eigen::Vector2d> area) {
    m_state->overlay.area = std::move(area);
    update();
}

void MapView::setGround(double height) {
    m_state->overlay.ground = height;
}

void MapView::setHint(const QString& text) {
    if (text == m_state->overlay.hint) return;
    m_state->overlay.hint = text;
    m_state->describe();
    update();
}

void MapView::setSeam(const std::optional<Measurement>& seam) {
    m_state->overlay.seam = seam;
    update();
}

void MapView::setCaptions(std::vector<MapCaption> captions) {
    m_state->overlay.captions = std::move(captions);
    update();
}

void MapView::setLinks(std::vector<MapLink> links) {
    if (links == m_state->overlay.links) return;
    m_state->overlay.links = std::move(links);
    update();
}

void MapView::State::describe() {
    const QString text = overlay.description();
    // Percentages change all the time: screen readers are notified only when the words change.
    static const QRegularExpression figures(QStringLiteral("\\d[\\d.,]*"));
    const auto words = [](QString reported) { return reported.remove(figures); };
    if (words(text) != words(view.accessibleDescription())) view.setAccessibleDescription(text);
}

bool MapView::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) return QWidget::event(event);
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const RobotMark* const robot =
        m_state->overlay.robotAt(QPointF(help.pos()), m_state->scenery.projection());
    QToolTip::showText(help.globalPos(), robot != nullptr ? robot->details : QString(), this);
    return true;
}

void MapView::startPose(const RobotMark& robot) {
    m_state->overlay.tools.startPose(robot);
    setCursor(Qt::CrossCursor);
}

void MapView::startArea() {
    m_state->overlay.tools.startArea();
    setCursor(Qt::CrossCursor);
}

void MapView::startGrab() {
    m_state->overlay.tools.startGrab();
    setCursor(Qt::SizeAllCursor);
}

void MapView::endGesture() {
    m_state->pointer.endGesture();
}

bool MapView::drawing() const {
    return m_state->pointer.drawing();
}

void MapView::mousePressEvent(QMouseEvent* event) {
    m_state->pointer.press(*event);
}

void MapView::mouseMoveEvent(QMouseEvent* event) {
    m_state->pointer.move(*event);
}

void MapView::mouseReleaseEvent(QMouseEvent* event) {
    m_state->pointer.release(*event);
}

void MapView::mouseDoubleClickEvent(QMouseEvent* event) {
    m_state->pointer.doubleClick(*event);
}

void MapView::wheelEvent(QWheelEvent* event) {
    m_state->pointer.roll(*event);
    event->accept();
}

void MapView::keyPressEvent(QKeyEvent* event) {
    if (!m_state->pointer.pressKey(*event)) event->ignore();
}

void MapView::leaveEvent(QEvent* event) {
    QWidget::leaveEvent(event);
    m_state->pointer.leave();
}

}  // namespace leitstand
