#pragma once

#include <QString>

#include "core/robot/robot_description.h"

#include "widgets/models/others_text.h"

namespace leitstand {

/// The names of a robot on screen.
struct RobotFace {
    QString name;    ///< "kurt3d": identifies the robot, in intents too
    QString letter;  ///< "K"
    QString title;   ///< "Kurt3D"
    int place = 0;   ///< in the team, from 0: chooses its colour

    friend bool operator==(const RobotFace&, const RobotFace&) = default;
};

/// Returns the face of @p robot. @p place: of the robot in its team, from 0.
[[nodiscard]] inline RobotFace faceOf(const RobotDescription& robot, int place) {
    return {QString::fromStdString(robot.name), othersText(robot.letter), othersText(robot.title), place};
}

}  // namespace leitstand
