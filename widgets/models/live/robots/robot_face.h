#pragma once

#include <QString>

#include "core/robot/robot_description.h"

#include "widgets/models/others_text.h"

namespace leitstand {

/// How a robot is named on the screen.
struct RobotFace {
    QString name;    ///< "kurt3d": identifies the robot, also in requests
    QString letter;  ///< "K"
    QString title;   ///< "Kurt3D"
    int place = 0;   ///< place in the team, from 0; determines its colour

    friend bool operator==(const RobotFace&, const RobotFace&) = default;
};

/// Returns the face of @p robot. @p place: place of the robot in its team, from 0.
[[nodiscard]] inline RobotFace faceOf(const RobotDescription& robot, int place) {
    return {QString::fromStdString(robot.name), othersText(robot.letter), othersText(robot.title), place};
}

}  // namespace leitstand
