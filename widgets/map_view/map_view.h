#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <QImage>
#include <QString>
#include <QWidget>

#include "core/mapping/map.h"
#include "core/mission/coverage/floor_tint.h"
#include "widgets/map_view/gestures/ground_pose.h"
#include "widgets/map_view/overlays/map_links.h"
#include "widgets/models/map/map_view_settings.h"
#include "widgets/models/victims/victim_rows.h"

namespace leitstand {

struct MapChanges;
struct RobotMark;

/// A point of the map under the cursor.
struct PickedPoint {
    Eigen::Vector3d pointInMap;  ///< [m]
    int scan = -1;               ///< its scan's position in Map::scans
    Label label = Label::Unlabelled;
};

/// Two picked points.
struct Measurement {
    Eigen::Vector3d from, to;  ///< in the map's frame [m]
};

/// Something said of a part of the map, over what is drawn there highest.
struct MapCaption {
    std::vector<Eigen::Vector3d> places;  ///< of the part, in the map's frame [m]
    QString text;
};

/// Shows a map. A plain raster widget: VTK draws in its own EGL context on one render thread; the widget
/// paints the picture last drawn. Mouse: left turns, middle or Shift+left shifts, wheel and right zooms.
/// GUI thread only.
class MapView final : public QWidget {
    Q_OBJECT
public:
    explicit MapView(QWidget* parent = nullptr);
    ~MapView() override;

    /// Shows @p map; scans already shown only move, new ones are added by a worker. The camera frames the map
    /// whenever scans come or go, until the user moves it.
    void setMap(MapPtr map);
    /// Hides the scans whose entry is false; scans beyond the end are shown.
    void setVisible(std::vector<bool> scanIsVisible);
    using QWidget::setVisible;

    /// The top look has a camera of its own; leaving it brings the other one back.
    void setSettings(const MapViewSettings& settings);
    /// The same, but a camera that follows no robot any more goes back to where it was left.
    void recall(const MapViewSettings& settings);
    [[nodiscard]] const MapViewSettings& settings() const;

    /// Looks from a preset side and frames the visible scans; in the top look always straight down.
    void setCamera(CameraPreset preset);

    /// Shows robots where they are now: costs no drawing of points. The camera follows the selected one while
    /// the settings say so.
    void setRobots(std::vector<RobotMark> robots);
    /// Marks victims and other finds; @p chosen stands out.
    void setFinds(std::vector<VictimRow> finds, const std::optional<FindKey>& chosen);
    /// Tints the floor that was searched and hatches what was missed; null: neither.
    void setFloorTint(FloorTintPtr tint);
    /// The scan of this MapScan::id stands out; 0: none.
    void setHighlighted(std::uint64_t id);
    /// Shows scans a second time, in one colour, where they might come to stand: by MapScan::id,
    /// in the map's frame. Empty: none.
    void setGhosts(std::map<std::uint64_t, Pose> scansInMap);
    /// The same for scans that the operator drags; while there are any, the others are not shown.
    void setDragged(std::map<std::uint64_t, Pose> scansInMap);
    /// Shows what came and what went in colours of their own, all else dimmed; null: neither.
    void setChanges(std::shared_ptr<const MapChanges> changes);
    /// Frames the scan of this MapScan::id.
    void showScan(std::uint64_t id);
    /// Moves the camera, which follows nothing any more, to @p place of the map [m].
    void showPlace(const Eigen::Vector3d& place);
    /// Nothing came to the map lately: it is greyed, robots and finds on it are not.
    void setStale(bool stale);
    /// Outlines an area on the floor (map frame [m]); empty: none.
    void setArea(std::vector<Eigen::Vector2d> area);
    /// Two places of which somebody asks whether they are one, with what lies between; empty: none.
    void setSeam(const std::optional<Measurement>& seam);
    /// Not while the camera follows a robot: there the map is for driving.
    void setCaptions(std::vector<MapCaption> captions);
    /// Draws these as lines; empty: none.
    void setLinks(std::vector<MapLink> links);
    /// Height of the floor that gestures draw on where no floor was scanned, map frame [m].
    void setGround(double height);
    /// Says @p text over the map; empty: nothing.
    void setHint(const QString& text);

    /// From now on the left button draws a pose of @p robot onto the floor: press is its place, a drag its
    /// heading (poseDrawn). The right button ends it.
    void startPose(const RobotMark& robot);
    /// From now on left clicks are corners of an area, a double click ends it (areaDrawn), the right button
    /// takes a corner back.
    void startArea();
    /// From now on the left button drags something over the floor (groundDragged), with Shift it turns it;
    /// the right button ends it.
    void startGrab();
    void endGesture();
    [[nodiscard]] bool drawing() const;  ///< a gesture is on

    /// While on, left clicks pick the two ends of a measurement; Esc or off removes it.
    void setMeasuring(bool on);
    [[nodiscard]] std::optional<Measurement> measurement() const;

    /// The point drawn nearest to @p position (widget coordinates) within 8 pixels, frontmost first, in the
    /// picture on screen.
    [[nodiscard]] std::optional<PickedPoint> pick(const QPoint& position) const;
    /// Where a map point is drawn now, in widget coordinates; nothing when behind the camera.
    [[nodiscard]] std::optional<QPointF> project(const Eigen::Vector3d& pointInMap) const;

    /// The picture in full detail with legend and scale, drawn now with everything set so far; waits for the
    /// render thread. Null when nothing can be drawn.
    [[nodiscard]] QImage picture();
    /// Whether the picture on screen shows everything set so far in full detail.
    [[nodiscard]] bool settled() const;
    /// Whether points of some scan are on screen, however much came since.
    [[nodiscard]] bool showsScans() const;

signals:
    void measured(const leitstand::Measurement& measurement);
    /// A pose was drawn while one was asked for; drawing goes on until endGesture().
    void poseDrawn(const leitstand::GroundPose& pose);
    void areaDrawn(const std::vector<Eigen::Vector2d>& area);
    void groundDragged(const leitstand::GroundDrag& drag);
    void gestureEnded();  ///< by the operator, without a result
    /// A double click onto the floor while nothing is drawn.
    void groundActivated(const Eigen::Vector3d& place);
    /// The operator moved the camera away from the robot that it followed.
    void followEnded();
    void hovered(const std::optional<leitstand::PickedPoint>& point);
    /// The render thread could not start; nothing will be drawn. In the user's language.
    void failed(const QString& why);
    void drawn();  ///< the points were drawn again, coarsely or fully
    /// The picture on screen is complete.
    void becameSettled();

protected:
    bool event(QEvent* event) override;  ///< a robot under the pointer tells how sure its place is
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    struct State;
    std::unique_ptr<State> m_state;
};

}  // namespace leitstand
