#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>
#include <QObject>
#include <QPointer>
#include <QString>

#include "widgets/map_view/gestures/ground_pose.h"

class QAction;

namespace leitstand {

class MapView;
struct RobotMark;

/// Handles what the operator draws on the map, one gesture at a time. Each gesture belongs to a command,
/// which is checked while the gesture is active.
class MapGestures final : public QObject {
    Q_OBJECT
public:
    /// Draws in @p view, which must outlive this object.
    MapGestures(MapView& view, QObject* parent);

    /// Lets the operator draw one pose of @p robot, for the command @p by. Shows @p hint over the map until
    /// the pose is drawn, then calls @p then with it.
    void armPose(QAction& by, const RobotMark& robot, const QString& hint,
                 std::function<void(const GroundPose&)> then);
    void armArea(QAction& by, const QString& hint,
                 std::function<void(const std::vector<Eigen::Vector2d>&)> then);
    /// Lets the operator drag something over the floor until disarm(). Calls @p then at every step.
    void armGrab(QAction& by, const QString& hint, std::function<void(const GroundDrag&)> then);
    void disarm();
    [[nodiscard]] bool armed() const { return m_by != nullptr; }

    /// Sets the text over the map that is shown while there is no gesture.
    void setCalmHint(const QString& text);

private:
    void arm(QAction& by, const QString& hint);

    MapView& m_view;
    QPointer<QAction> m_by;
    QString m_calmHint;
    std::function<void(const GroundPose&)> m_thenPose;
    std::function<void(const std::vector<Eigen::Vector2d>&)> m_thenArea;
    std::function<void(const GroundDrag&)> m_thenDrag;
};

}  // namespace leitstand
