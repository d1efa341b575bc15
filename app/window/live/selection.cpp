#include "app/window/live/selection.h"

#include <algorithm>

#include "app/session/station/station.h"

namespace leitstand {

Selection::Selection(const Station& station, QObject* parent) : QObject(parent), m_station(station) {
    if (!robots().empty()) m_name = QString::fromStdString(robots().front().name);
}

const std::vector<RobotDescription>& Selection::robots() const {
    return m_station.robots();
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
