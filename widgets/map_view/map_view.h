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
struct RobotGrid;
struct RobotMark;

/// A point of the map under the cursor.
struct PickedPoint {
    Eigen::Vector3d pointInMap;  ///< position in the map [m]
    int scan = -1;               ///< index of the point's scan in Map::scans; -1: none
    Label label = Label::Unlabelled;
};

/// Two picked points.
struct Measurement {
    Eigen::Vector3d from, to;  ///< in the map's frame [m]
};

/// A text about a part of the map, drawn above that part's highest place on screen.
struct MapCaption {
    std::vector<Eigen::Vector3d> places;  ///< points of that part, in the map's frame [m]
    QString text;
};

/// Shows a map. It is a plain raster widget: VTK draws in its own EGL context on one render thread, and the
/// widget paints the last picture. Mouse: left turns, middle or Shift+left shifts, wheel and right zoom. GUI
/// thread only.
class MapView final : public QWidget {
    Q_OBJECT
public:
    explicit MapView(QWidget* parent = nullptr);
    ~MapView() override;

    /// Shows @p map. Scans that are already shown only move; a worker adds new ones. The camera frames the
    /// map whenever scans are added or removed, until the user moves it.
    void setMap(MapPtr map);
    /// Hides the scans whose entry is false; scans beyond the end are shown.
    void setVisible(std::vector<bool> scanIsVisible);
    using QWidget::setVisible;

    /// Applies @p settings. The top look has its own camera; after it, the other camera is used again.
    void setSettings(const MapViewSettings& settings);
    /// Applies @p settings. A camera that stops following a robot returns to where it was before.
    void recall(const MapViewSettings& settings);
    [[nodiscard]] const MapViewSettings& settings() const;

    /// Looks from the side of @p preset, frames the visible scans, and stops following a robot. In the top
    /// look the camera always looks straight down.
    void setCamera(CameraPreset preset);

    /// Shows robots at their present poses, without drawing points again. The camera follows the selected
    /// robot if the settings say so.
    void setRobots(std::vector<RobotMark> robots);
    /// Marks victims and other finds; highlights @p chosen.
    void setFinds(std::vector<VictimRow> finds, const std::optional<FindKey>& chosen);
    /// Tints searched floor and hatches missed floor; null: neither.
    void setFloorTint(FloorTintPtr tint);
    /// Shows a robot's own grid over the map; empty: none.
    void setGrid(std::optional<RobotGrid> grid);
    /// Highlights the scan of this MapScan::id; 0: none.
    void setHighlighted(std::uint64_t id);
    /// Also shows scans at poses that they may get, in a single colour. @p scansInMap: these poses by
    /// MapScan::id, in the map's frame; empty: none.
    void setGhosts(std::map<std::uint64_t, Pose> scansInMap);
    /// Does the same for scans that the operator drags. Meanwhile, the scans of setGhosts() are hidden.
    void setDragged(std::map<std::uint64_t, Pose> scansInMap);
    /// Shows new things and things that have disappeared in their own colours, and dims everything else.
    /// Null: neither.
    void setChanges(std::shared_ptr<const MapChanges> changes);
    /// Frames the scan of this MapScan::id.
    void showScan(std::uint64_t id);
    /// Moves the camera to @p place of the map [m] and stops following.
    void showPlace(const Eigen::Vector3d& place);
    /// Sets whether the map is grey, for example because it received no new data recently. Robots and finds
    /// keep their colours.
    void setStale(bool stale);
    /// Outlines an area on the floor (map frame [m]); empty: none.
    void setArea(std::vector<Eigen::Vector2d> area);
    /// Shows two places that may be the same, and the distance between them; empty: none.
    void setSeam(const std::optional<Measurement>& seam);
    /// Draws @p captions. They are hidden while the camera follows a robot, since the map is then used for
    /// driving.
    void setCaptions(std::vector<MapCaption> captions);
    /// Draws these links as lines; empty: none.
    void setLinks(std::vector<MapLink> links);
    /// Sets the floor height for gestures where no floor was scanned, in the map's frame [m].
    void setGround(double height);
    /// Shows @p text over the map; empty: nothing.
    void setHint(const QString& text);

    /// Lets the operator draw poses of @p robot onto the floor, each emitted by poseDrawn(). Pressing the
    /// left button sets the place, dragging sets the heading. The right button ends the gesture.
    void startPose(const RobotMark& robot);
    /// Lets the operator draw an area: left clicks add corners, a double click completes the area
    /// (areaDrawn()), the right button removes the last corner.
    void startArea();
    /// Lets the operator drag something over the floor with the left button, or turn it with Shift
    /// (groundDragged()). The right button ends the gesture.
    void startGrab();
    void endGesture();
    [[nodiscard]] bool drawing() const;  ///< whether a gesture is active

    /// While on, left clicks pick the two ends of a measurement. Esc, or switching it off, removes the
    /// measurement.
    void setMeasuring(bool on);
    [[nodiscard]] std::optional<Measurement> measurement() const;

    /// Returns the point that pickPoint() finds at @p position (widget coordinates) in the picture on screen;
    /// empty: none within 8 pixels.
    [[nodiscard]] std::optional<PickedPoint> pick(const QPoint& position) const;
    /// Returns where a map point is drawn now, in widget coordinates; empty when it is behind the camera.
    [[nodiscard]] std::optional<QPointF> project(const Eigen::Vector3d& pointInMap) const;

    /// Draws everything that was set so far in full detail, with legend and scale. Waits for the render
    /// thread. Null when nothing can be drawn.
    [[nodiscard]] QImage picture();
    /// Whether the picture on the screen shows everything that was set so far in full detail.
    [[nodiscard]] bool settled() const;
    /// Whether points of any scan are on the screen, even if the picture is out of date.
    [[nodiscard]] bool showsScans() const;

signals:
    void measured(const leitstand::Measurement& measurement);
    /// The operator drew a pose after startPose(). Drawing continues until endGesture().
    void poseDrawn(const leitstand::GroundPose& pose);
    void areaDrawn(const std::vector<Eigen::Vector2d>& area);
    void groundDragged(const leitstand::GroundDrag& drag);
    void gestureEnded();  ///< the operator ended it without a result
    /// A double click on the floor while no gesture is active.
    void groundActivated(const Eigen::Vector3d& place);
    /// The operator moved the camera away from the robot it followed.
    void followEnded();
    void hovered(const std::optional<leitstand::PickedPoint>& point);
    /// The render thread could not be started, so nothing will be drawn. @p why: in the user's language.
    void failed(const QString& why);
    void drawn();  ///< the points were drawn again, coarsely or fully
    /// The picture on screen is complete.
    void becameSettled();

protected:
    bool event(QEvent* event) override;  ///< also shows the tooltip of a robot: how certain its position is
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
