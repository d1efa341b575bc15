#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include "core/mapping/map.h"
#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/render/view_renderer.h"
#include "widgets/map_view/robots/follow_camera.h"
#include "widgets/map_view/scene/scene_builder.h"

class QWidget;

namespace leitstand {

/// The scene of a map view. Passes requests to the worker, and the content that the worker makes to the
/// render thread. Keeps the last picture and the cameras. GUI thread only.
class MapScenery final : public QObject {
    Q_OBJECT
public:
    /// Draws for @p view, with its size and pixel ratio, while it is visible.
    explicit MapScenery(QWidget& view);
    ~MapScenery() override;

    void setMap(MapPtr map);
    void setVisible(std::vector<bool> scanIsVisible);
    /// Sets the robots, for the colours and names of their scans.
    void setTeam(std::vector<SceneRobot> robots);
    /// Applies @p settings. A camera that stops following a robot stays where it is.
    void setSettings(const MapViewSettings& settings);
    /// Applies @p settings. Cameras that follow no robot return to where they were before they followed one.
    void recall(const MapViewSettings& settings);
    [[nodiscard]] const MapViewSettings& settings() const { return m_order.settings; }

    /// Highlights the scan of this id; 0: none.
    void setHighlighted(std::uint64_t id);
    /// Implements MapView::setGhosts(), or MapView::setDragged() if @p dragged is true.
    void setGhosts(std::map<std::uint64_t, Pose> scansInMap, bool dragged);
    void setChanges(std::shared_ptr<const MapChanges> changes);  ///< implements MapView::setChanges()

    [[nodiscard]] const MapCamera& camera() const;
    /// Moves the camera to the selected robot's new pose @p baseInMap. Does nothing unless the settings ask
    /// to follow a robot.
    void aim(const Pose& baseInMap);
    /// Whether the camera follows a robot.
    [[nodiscard]] bool following() const;
    /// Stops following; the camera stays where it is.
    void stopFollowing();
    /// Frames the scan of this id and stops following. Does nothing when the scan has no points on screen.
    void frameScan(std::uint64_t id);
    /// Moves the focus to @p place of the map [m], keeps the view direction, and stops following.
    void centre(const Eigen::Vector3d& place);
    /// Moves the camera. A coarse picture is drawn at once, a full one when the camera is at rest.
    void moveCamera(const MapCamera& camera);
    void setCamera(CameraPreset preset);

    /// Requests a full picture if the one on the screen does not show everything.
    void refresh();
    /// Draws a full picture of everything that was set so far, and waits for it.
    void finish();

    /// Returns the picture on the screen; its image is null before the first picture.
    [[nodiscard]] const MapPicture& picture() const { return m_picture; }
    /// Returns the projection of the picture on the screen. If there is none, returns that of the next
    /// picture.
    [[nodiscard]] MapProjection projection() const;
    [[nodiscard]] bool settled() const;
    /// Why nothing can be drawn; empty: there was no failure.
    [[nodiscard]] const QString& failure() const { return m_failure; }

signals:
    void pictureChanged();
    void becameSettled();
    void failed(const QString& why);

private:
    /// A camera, and whether it keeps the map framed. If so, it frames the map whenever scans are added or
    /// removed, until the operator moves the camera.
    struct FramedCamera {
        MapCamera camera;
        bool follows = true;
        bool due = true;    ///< whether scans were added or removed since it last framed the map
        bool fits = false;  ///< whether it framed the map at least once
    };

    [[nodiscard]] FramedCamera& activeCamera();
    void startFollowing();
    void drawFollowing();
    [[nodiscard]] DrawOrder drawOrder(bool full) const;
    [[nodiscard]] bool showsEverything(const MapPicture& picture) const;
    void submit();
    void frame();
    void takeContent(SceneContentPtr content);
    void takePicture(MapPicture picture);
    void takeFailure(const std::string& why);
    void draw(bool full);

    QWidget& m_view;
    SceneOrder m_order;
    SceneContentPtr m_content = std::make_shared<const SceneContent>();
    FramedCamera m_freeCamera, m_topCamera;
    FollowCamera m_follow;
    Pose m_robot = Pose::Identity();  ///< last pose of the followed robot
    QElapsedTimer m_sinceAim;
    QTimer m_followed;      ///< runs until a camera that follows a robot may be drawn again
    bool m_wentOn = false;  ///< whether the camera moved since it was drawn
    QTimer m_glide;         ///< keeps moving the camera while a robot sends no new poses
    MapPicture m_picture;
    bool m_wasSettled = false;
    QString m_failure;
    QTimer m_rest;  ///< runs while the camera moves
    ViewRenderer m_renderer;
    SceneBuilder m_builder;  // last: its thread calls back
};

}  // namespace leitstand
