#pragma once

#include <array>
#include <string>
#include <vector>

#include <QPointF>
#include <QString>

#include "core/base/time.h"
#include "core/mission/state/robot_state.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// Something that a detector sees, as it is drawn over a camera's picture.
struct DetectionMark {
    /// In order around it, as shares of the picture's width and height.
    std::array<QPointF, 4> corners;
    QString text;  ///< what it is, and how sure the detector is; may be empty
};

/// The picture that is shown, as it was received.
struct PictureUnderDetections {
    std::string sensor, frame;
    Time stamp{}, received{};
    int width = 0, height = 0;  ///< [px]
};

/// Returns what the detectors of @p robot see in @p picture. A detector belongs to the camera that the
/// robot's file names for it, else to the one whose frame its messages have, else to the robot's only camera.
/// What it saw more than a second before or after the picture was taken is left out.
[[nodiscard]] std::vector<DetectionMark> detectionMarks(const RobotDescription& robot,
                                                        const RobotState& reported,
                                                        const PictureUnderDetections& picture);

}  // namespace leitstand
