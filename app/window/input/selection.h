#pragma once

#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "core/robot/robot_description.h"
#include "widgets/models/live/robots/robot_face.h"

namespace leitstand {

/// Holds which robot the operator looks at and drives.
class Selection final : public QObject {
    Q_OBJECT
public:
    /// Selects the first of @p robots.
    explicit Selection(std::vector<RobotDescription> robots, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_robots; }
    /// Returns the selected robot; null: the station has none.
    [[nodiscard]] const RobotDescription* robot() const { return find(m_name); }
    [[nodiscard]] const QString& name() const { return m_name; }
    [[nodiscard]] RobotFace face() const;  ///< face of robot(); empty: there is no robot
    [[nodiscard]] const RobotDescription* find(const QString& name) const;
    [[nodiscard]] std::vector<RobotFace> faces() const;  ///< faces of robots(), in their order
    /// Returns the face of @p robot, which must be one of robots().
    [[nodiscard]] RobotFace faceOfRobot(const RobotDescription& robot) const;

    /// Selects the robot @p name. Does nothing when it is unknown or already selected.
    void select(const QString& name);
    /// Selects the robot with this @p number in robots(), counted from 1. Does nothing when there is none.
    void selectNumber(int number);

signals:
    void changed();

private:
    const std::vector<RobotDescription> m_robots;
    QString m_name;
};

}  // namespace leitstand
