#pragma once

#include <QString>
#include <QStringList>

#include "core/station/robot_view.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// The stage of a robot's stop.
enum class StopStage {
    None,          ///< no stop stands
    Sent,          ///< not answered yet
    Acknowledged,  ///< accepted; the robot still moves, or its motion is unknown
    Standing,
    Releasing,  ///< the release is on its way
};

/// The stop of one robot beside the stop button.
struct StopLine {
    RobotFace face;
    StopStage stage = StopStage::None;
    QString text;     ///< "confirmed · moves"
    QString brief;    ///< the same where there is little room: "moves", "? 4.2 s"
    QString details;  ///< who stopped the robot, or why a release was refused; may be empty
    Tone tone = Tone::Normal;
    bool releasable = false;  ///< this station may release it now

    friend bool operator==(const StopLine&, const StopLine&) = default;
};

[[nodiscard]] StopLine stopLineOf(const RobotFace& face, const RobotView& robot);

/// Returns every possible StopLine::brief, with figures at their widest. A place with room for each of these
/// never cuts a text.
[[nodiscard]] QStringList stopBriefs();

}  // namespace leitstand
