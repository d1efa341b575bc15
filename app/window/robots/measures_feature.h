#pragma once

#include <QObject>
#include <QString>

#include "app/services/models/robot_bodies.h"
#include "app/window/panes/view_context.h"

class QDialog;

namespace leitstand {

struct LiveMoment;
class MeasuresForm;

/// The form in which the operator enters how large a robot is and where its sensors sit.
class MeasuresFeature final : public QObject {
    Q_OBJECT
public:
    explicit MeasuresFeature(const LiveContext& context);

signals:
    /// The file of @p robot was written to @p file: the station shall be opened with it.
    void fileChanged(const QString& robot, const QString& file);

private:
    void open();
    void show(const LiveMoment& moment);
    void takeModel();
    void save();

    LiveContext m_context;
    QDialog* m_dialog;
    MeasuresForm* m_form;
    std::string m_robot;  ///< whose measures are shown
    RobotBodies m_bodies;
    ModelBodyPtr m_body;  ///< the robot's model; null: none is known yet
};

}  // namespace leitstand
