#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>
#include <QString>

#include "core/base/pose.h"
#include "core/base/rotation/heading.h"
#include "core/mapping/live/trail.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// A robot as a map draws it.
struct RobotMark {
    RobotFace face;
    std::vector<Eigen::Vector2d> footprint;  ///< base_link [m]
    double height = 0.0;                     ///< [m]
    bool tracked = false;                    ///< tracks, otherwise wheels
    Pose baseInMap = Pose::Identity();
    TrailPtr trail = {};                     ///< in the map's frame; may be null
    bool afterGap = false;                   ///< the path from the trail's end to baseInMap is unknown
    std::optional<Pose> goalInMap = {};      ///< where the robot was sent; empty: nowhere
    std::optional<double> doubtRadius = {};  ///< the robot is within this radius [m]; empty: certain
    QString note = {};                       ///< shown beside it: "place uncertain"; may be empty
    QString details = {};      ///< how sure its place is, in full: for tooltips and screen readers
    Tone tone = Tone::Normal;  ///< of the note
    bool selected = false;
    bool stale = false;  ///< nothing was received from it lately: it may be elsewhere
};

}  // namespace leitstand
