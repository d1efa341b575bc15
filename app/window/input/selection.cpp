#include "app/window/input/selection.h"

#include <algorithm>
#include <utility>

namespace leitstand {

Selection::Selection(std::vector<RobotDescription> robots, QObject* parent)
    : QObject(parent), m_robots(std::move(robots)) {
    if (!m_robots.empty()) m_name = QString::fromStdString(m_robots.front().name);
}

const RobotDescription* Selection::find(const QString& name) const {
    const auto found =
        std::find_if(robots().begin(), robots().end(),
                     [wanted = name.toStdString()](const auto& one) { return one.name == wanted; });
    return found == robots().end() ? nullptr : &*found;
}

RobotFace Selection::faceOfRobot(const RobotDescription& robot) const {
    const auto place = std::find_if(robots().begin(), robots().end(),
                                    [&](const auto& one) { return one.name == robot.name; });
    return faceOf(robot, static_cast<int>(place - robots().begin()));
}

std::vector<RobotFace> Selection::faces() const {
    std::vector<RobotFace> faces;
    for (const RobotDescription& robot : robots()) faces.push_back(faceOfRobot(robot));
    return faces;
}

RobotFace Selection::face() const {
    const RobotDescription* const selected = robot();
    return selected == nullptr ? RobotFace{} : faceOfRobot(*selected);
}

void Selection::select(const QString& name) {
    if (name == m_name || find(name) == nullptr) return;
    m_name = name;
    emit changed();
}

void Selection::selectNumber(int number) {
    if (number < 1 || number > static_cast<int>(robots().size())) return;
    select(QString::fromStdString(robots()[static_cast<std::size_t>(number - 1)].name));
}

}  // namespace leitstand
