#pragma once

#include <optional>
#include <vector>

#include <QObject>
#include <QString>

#include "core/robot/robot_description.h"
#include "widgets/models/live/robots/robot_face.h"

namespace leitstand {

/// Which robot the operator looks at and drives: the one place that says so.
class Selection final : public QObject {
    Q_OBJECT
public:
    /// The first of @p robots is selected.
    explicit Selection(std::vector<RobotDescription> robots, QObject* parent = nullptr);

    [[nodiscard]] const std::vector<RobotDescription>& robots() const { return m_robots; }
    /// The selected one; null when the station has none.
    [[nodiscard]] const RobotDescription* robot() const { return find(m_name); }
    [[nodiscard]] const QString& name() const { return m_name; }
    [[nodiscard]] RobotFace face() const;  ///< of the selected one
    [[nodiscard]] const RobotDescription* find(const QString& name) const;
    [[nodiscard]] std::vector<RobotFace> faces() const;  ///< of robots(), in their order
    /// How @p robot, one of robots(), looks.
    [[nodiscard]] RobotFace faceOfRobot(const RobotDescription& robot) const;

    /// Does nothing for a name that is unknown or selected already.
    void select(const QString& name);
    /// The @p number th, from 1.
    void selectNumber(int number);

signals:
    void changed();

private:
    const std::vector<RobotDescription> m_robots;
    QString m_name;
};

}  // namespace leitstand
