#pragma once

#include <QString>
#include <QStringList>

#include "core/station/robot_view.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// The stage of a robot's stop.
enum class StopStage {
    None,          ///< no stop is in force
    Sent,          ///< it was sent, but not answered yet
    Acknowledged,  ///< accepted; the robot still moves, or it is unknown whether it does
    Standing,
    Releasing,  ///< the release was sent
};

/// The stop of one robot, as text beside the stop button.
struct StopLine {
    RobotFace face;
    StopStage stage = StopStage::None;
    QString text;     ///< "confirmed · moves"
    QString brief;    ///< the same for narrow places: "moves", "? 4.2 s"
    QString details;  ///< who stopped the robot, or why a release was refused; may be empty
    Tone tone = Tone::Normal;
    bool releasable = false;  ///< whether this station may release it now

    friend bool operator==(const StopLine&, const StopLine&) = default;
};

[[nodiscard]] StopLine stopLineOf(const RobotFace& face, const RobotView& robot);

/// Returns every possible StopLine::brief, with the widest figures. If a place is wide enough for each of
/// these, no text is cut there.
[[nodiscard]] QStringList stopBriefs();

}  // namespace leitstand
