#pragma once

#include <QString>
#include <QStringList>

#include "core/station/robot_view.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// How far the stop of a robot came.
enum class StopStage {
    None,          ///< no stop stands
    Sent,          ///< not answered yet
    Acknowledged,  ///< taken; it still moves, or nothing tells whether
    Standing,
    Releasing,  ///< the release is on its way
};

/// The stop of one robot beside the stop button.
struct StopLine {
    RobotFace face;
    StopStage stage = StopStage::None;
    QString text;     ///< "acknowledged · moves"
    QString brief;    ///< the same where there is little room: "moves", "? 4.2 s"
    QString details;  ///< whose stop it is, why a release was refused; may be empty
    Tone tone = Tone::Normal;
    bool releasable = false;  ///< this station may let it go now

    friend bool operator==(const StopLine&, const StopLine&) = default;
};

[[nodiscard]] StopLine stopLineOf(const RobotFace& face, const RobotView& robot);

/// Each StopLine::brief that there is, figures as wide as they get: who has room for all never cuts one.
[[nodiscard]] QStringList stopBriefs();

}  // namespace leitstand
