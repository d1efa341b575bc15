#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <QString>

#include "core/base/pose.h"
#include "core/base/rotation/heading.h"
#include "core/mapping/live/trail.h"
#include "core/robot/model/model_body.h"
#include "widgets/models/live/robots/robot_face.h"
#include "widgets/models/map/robots/robot_drawings.h"
#include "widgets/models/map/robots/robot_plans.h"
#include "widgets/models/tone.h"

namespace leitstand {

/// A robot as it is drawn on a map.
struct RobotMark {
    RobotFace face;
    std::vector<Eigen::Vector2d> footprint;  ///< in base_link [m]
    double height = 0.0;                     ///< [m]
    bool tracked = false;                    ///< whether it has tracks; otherwise wheels
    Pose baseInMap = Pose::Identity();
    ModelBodyPtr body = {};              ///< what it looks like; null: it is drawn as a symbol
    std::vector<Pose> linksInBase = {};  ///< poses of the body's links
    TrailPtr trail = {};                 ///< in the map's frame; may be null
    bool afterGap = false;  ///< whether the path from the end of the trail to baseInMap is unknown
    std::shared_ptr<const PlannedPaths> plans = {};  ///< ways that it plans to take; null: none
    std::shared_ptr<const Drawings> drawings = {};   ///< what it draws; null: nothing
    std::optional<Pose> goalInMap = {};              ///< where it was sent; empty: nowhere
    std::vector<Pose> waypoints = {};                ///< where it goes after its goal, in order
    /// The robot is within this distance [m]; empty: its place is certain.
    std::optional<double> doubtRadius = {};
    QString note = {};         ///< text beside it: "place uncertain"; may be empty
    QString details = {};      ///< how certain its place is, full text for tooltips and screen readers
    Tone tone = Tone::Normal;  ///< tone of the note
    bool selected = false;
    bool stale = false;  ///< nothing was received from it recently, so it may be elsewhere
};

}  // namespace leitstand
