#pragma once

#include <QKeySequence>
#include <QObject>
#include <QStringList>

#include <Eigen/Core>

#include "app/services/finds/freezing.h"
#include "app/window/panes/camera/camera_views.h"
#include "app/window/panes/camera/picture_looks.h"
#include "app/window/panes/view_context.h"
#include "core/robot/control/pan_tilt.h"

class QAction;

namespace leitstand {

class CameraPane;
class CameraTurning;
struct LiveMoment;

/// The selected robot's cameras: a large picture ("camera") with what the driver must know, and a second
/// picture beside it ("right"). Also has commands for looks, turning and snapshots.
class CameraFeature final : public QObject {
    Q_OBJECT
public:
    /// Without a live station in @p context, cameras cannot be turned or take snapshots.
    explicit CameraFeature(const ViewContext& context);

    [[nodiscard]] QWidget& large() const;  ///< pane of the camera with which the operator drives
    [[nodiscard]] QWidget& small() const;  ///< pane of the second camera
    /// Returns a text for each camera in a pane that has sent no picture yet.
    [[nodiscard]] QStringList missing() const;
    [[nodiscard]] const CameraViews& views() const { return m_views; }
    void setPointing(bool pointing);  ///< sets whether the next click into a picture emits pointed()

public slots:
    // These turn the large camera and what else is on its pan-tilt unit. Positive pan turns to the left,
    // positive tilt down.
    void turnTo(double pan, double tilt);   ///< [rad]
    void turnBy(double pan, double tilt);   ///< [rad]
    void setRate(double pan, double tilt);  ///< continuously, until the next call [rad/s]
    void recentre();                        ///< recentres all cameras of the robot

signals:
    void pointed(const PicturePoint& at);  ///< the operator pointed into a picture of the selected robot
    void pointingEnded();
    void driveWanted();  ///< the large picture was clicked

private:
    void addTurning();
    void addLooks();
    void addInfrared();
    QAction& add(const char* id, const QString& text, const QString& hint, const QKeySequence& keys = {},
                 bool checkable = false);
    void choose();     ///< selects cameras for the panes when a robot is selected
    void showPanes();  ///< shows what is known about the cameras in both panes
    void enable();     ///< enables commands that the selected robot's cameras support
    void applyLooks();
    void showPicture(const ShownPicturePtr& picture);
    void forget(const std::string& robot, const std::string& sensor);
    void showIn(CameraPane& pane, const ShownPicturePtr& picture);
    void show(const LiveMoment& moment);
    void point(CameraPlace place, const QPointF& at);
    void drag(const QPointF& from, const QPointF& to, bool first);
    void keep(CameraPlace place);  ///< takes a snapshot
    [[nodiscard]] CameraPane& pane(CameraPlace place) const;
    [[nodiscard]] CameraTurning* turning() const;  ///< null: there is no live robot
    [[nodiscard]] std::string robotName() const;

    ViewContext m_context;
    CameraViews m_views;
    PictureLooks m_looks;
    CameraPane *m_large, *m_small;
    PanTiltAngles m_grabbedAt;                             ///< the camera's angles when dragging began
    Eigen::Vector3d m_grabbed = Eigen::Vector3d::UnitZ();  ///< direction under the pointer at that time
};

}  // namespace leitstand
