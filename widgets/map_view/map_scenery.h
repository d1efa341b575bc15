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

/// What a map view shows: hands orders to the worker, its content to the render thread, and keeps the picture
/// drawn last and the cameras. GUI thread.
class MapScenery final : public QObject {
    Q_OBJECT
public:
    /// Draws for @p view, whose size, pixel ratio and visibility count.
    explicit MapScenery(QWidget& view);
    ~MapScenery() override;

    void setMap(MapPtr map);
    void setVisible(std::vector<bool> scanIsVisible);
    /// Whose colours and names the robots' scans have.
    void setTeam(std::vector<SceneRobot> robots);
    /// A camera that followed a robot and does no more stays where it is.
    void setSettings(const MapViewSettings& settings);
    /// The same, but cameras that follow nothing are where they were left.
    void recall(const MapViewSettings& settings);
    [[nodiscard]] const MapViewSettings& settings() const { return m_order.settings; }

    /// The scan of this id stands out; 0: none.
    void setHighlighted(std::uint64_t id);
    /// As of MapView; @p dragged: setDragged().
    void setGhosts(std::map<std::uint64_t, Pose> scansInMap, bool dragged);
    void setChanges(std::shared_ptr<const MapChanges> changes);  ///< as of MapView

    [[nodiscard]] const MapCamera& camera() const;
    /// The robot that the camera follows is there now.
    void aim(const Pose& baseInMap);
    /// Whether the camera goes with a robot.
    [[nodiscard]] bool following() const;
    /// The camera stays where it is from now on.
    void stopFollowing();
    /// Frames the scan of this id, without following anything. Nothing when it has no points on screen.
    void frameScan(std::uint64_t id);
    /// Looks at @p place of the map [m] as it looked before, without following anything.
    void centre(const Eigen::Vector3d& place);
    /// Moves the camera; a coarse picture comes at once, a full one when it comes to rest.
    void moveCamera(const MapCamera& camera);
    void setCamera(CameraPreset preset);

    /// Asks for a full picture if the one there is does not show everything.
    void refresh();
    /// A full picture of everything set so far; waits for it.
    void finish();

    /// What is on screen; its image is null before the first picture.
    [[nodiscard]] const MapPicture& picture() const { return m_picture; }
    /// How the picture on screen was projected, or the next one will be.
    [[nodiscard]] MapProjection projection() const;
    [[nodiscard]] bool settled() const;
    /// Why nothing can be drawn; empty when all is well.
    [[nodiscard]] const QString& failure() const { return m_failure; }

signals:
    void pictureChanged();
    void becameSettled();
    void failed(const QString& why);

private:
    /// A camera, and whether it frames the map: until somebody moves it, and then only when scans come or go.
    struct FramedCamera {
        MapCamera camera;
        bool follows = true;
        bool due = true;    ///< scans came or went since it framed them
        bool fits = false;  ///< it framed some
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
    Pose m_robot = Pose::Identity();  ///< that was aimed at last
    QElapsedTimer m_sinceAim;
    QTimer m_followed;      ///< runs until the camera that goes with a robot is drawn again
    bool m_wentOn = false;  ///< since it was drawn
    QTimer m_glide;         ///< on to where a robot is of which nothing is told any more
    MapPicture m_picture;
    bool m_wasSettled = false;
    QString m_failure;
    QTimer m_rest;  ///< runs while the camera moves
    ViewRenderer m_renderer;
    SceneBuilder m_builder;  // last: its thread calls back
};

}  // namespace leitstand
