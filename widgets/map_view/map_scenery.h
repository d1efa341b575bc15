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

/// The scene of a map view. Passes orders to the worker, and the content that the worker makes to the render
/// thread. Keeps the last picture and the cameras. GUI thread only.
class MapScenery final : public QObject {
    Q_OBJECT
public:
    /// Draws for @p view, with its size and pixel ratio, while it is visible.
    explicit MapScenery(QWidget& view);
    ~MapScenery() override;

    void setMap(MapPtr map);
    void setVisible(std::vector<bool> scanIsVisible);
    /// Sets the robots that give their scans colours and names.
    void setTeam(std::vector<SceneRobot> robots);
    /// Applies @p settings. A camera that stops following a robot stays where it is.
    void setSettings(const MapViewSettings& settings);
    /// Applies @p settings; cameras that follow no robot return to where they were left.
    void recall(const MapViewSettings& settings);
    [[nodiscard]] const MapViewSettings& settings() const { return m_order.settings; }

    /// Highlights the scan of this id; 0: none.
    void setHighlighted(std::uint64_t id);
    /// As MapView::setGhosts(), or as MapView::setDragged() when @p dragged is true.
    void setGhosts(std::map<std::uint64_t, Pose> scansInMap, bool dragged);
    void setChanges(std::shared_ptr<const MapChanges> changes);  ///< as MapView::setChanges()

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
    /// Moves the camera. A coarse picture comes at once, a full one when the camera rests.
    void moveCamera(const MapCamera& camera);
    void setCamera(CameraPreset preset);

    /// Requests a full picture if the one on screen does not show everything.
    void refresh();
    /// Draws a full picture of everything set so far, and waits for it.
    void finish();

    /// Returns the picture on screen; the image is null before the first picture.
    [[nodiscard]] const MapPicture& picture() const { return m_picture; }
    /// Returns the projection of the picture on screen; without a picture, of the next one.
    [[nodiscard]] MapProjection projection() const;
    [[nodiscard]] bool settled() const;
    /// Why nothing can be drawn; empty without a failure.
    [[nodiscard]] const QString& failure() const { return m_failure; }

signals:
    void pictureChanged();
    void becameSettled();
    void failed(const QString& why);

private:
    /// A camera, and whether it keeps the map framed: it then frames the map when scans come or go, until the
    /// operator moves the camera.
    struct FramedCamera {
        MapCamera camera;
        bool follows = true;
        bool due = true;    ///< scans came or went since it last framed the map
        bool fits = false;  ///< it framed the map at least once
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
    QTimer m_followed;      ///< runs until the camera that follows a robot may be drawn again
    bool m_wentOn = false;  ///< the camera moved since it was drawn
    QTimer m_glide;         ///< moves the camera on to a robot that sends no new poses
    MapPicture m_picture;
    bool m_wasSettled = false;
    QString m_failure;
    QTimer m_rest;  ///< runs while the camera moves
    ViewRenderer m_renderer;
    SceneBuilder m_builder;  // last: its thread calls back
};

}  // namespace leitstand
