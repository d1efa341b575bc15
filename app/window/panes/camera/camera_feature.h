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

/// The selected robot's cameras: one large ("camera"), with what the driver has to know in it, another beside
/// it ("right"); how they are looked at, turned and kept.
class CameraFeature final : public QObject {
    Q_OBJECT
public:
    /// Without a station cameras are only looked at.
    explicit CameraFeature(const ViewContext& context);

    [[nodiscard]] QWidget& large() const;  ///< pane of the camera that the operator drives by
    [[nodiscard]] QWidget& small() const;  ///< pane of the second camera
    /// Cameras that are in a pane and have sent no picture yet.
    [[nodiscard]] QStringList missing() const;
    [[nodiscard]] const CameraViews& views() const { return m_views; }
    void setPointing(bool pointing);  ///< the next click into a picture points

public slots:
    // The large camera, and what is on its pan-tilt unit: pan to the left, tilt down.
    void turnTo(double pan, double tilt);   ///< [rad]
    void turnBy(double pan, double tilt);   ///< [rad]
    void setRate(double pan, double tilt);  ///< on and on, until told otherwise [rad/s]
    void recentre();                        ///< all cameras of the robot

signals:
    void pointed(const PicturePoint& at);  ///< into a picture of the selected robot
    void pointingEnded();
    void driveWanted();  ///< the large picture was clicked

private:
    void addTurning();
    void addLooks();
    void addInfrared();
    QAction& add(const char* id, const QString& text, const QString& hint, const QKeySequence& keys = {},
                 bool checkable = false);
    void choose();     ///< cameras for the panes of a robot newly selected
    void showPanes();  ///< what is known of their cameras
    void enable();     ///< what the selected robot's cameras can do
    void applyLooks();
    void showPicture(const ShownPicturePtr& picture);
    void forget(const std::string& robot, const std::string& sensor);
    void showIn(CameraPane& pane, const ShownPicturePtr& picture);
    void show(const LiveMoment& moment);
    void point(CameraPlace place, const QPointF& at);
    void drag(const QPointF& from, const QPointF& to, bool first);
    void keep(CameraPlace place);  ///< a snapshot
    [[nodiscard]] CameraPane& pane(CameraPlace place) const;
    [[nodiscard]] CameraTurning* turning() const;  ///< null: nobody is there to be turned
    [[nodiscard]] std::string robotName() const;

    ViewContext m_context;
    CameraViews m_views;
    PictureLooks m_looks;
    CameraPane *m_large, *m_small;
    PanTiltAngles m_grabbedAt;                             ///< angles when the picture was taken hold of
    Eigen::Vector3d m_grabbed = Eigen::Vector3d::UnitZ();  ///< direction then
};

}  // namespace leitstand
