#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/services/finds/recent_evidence.h"
#include "core/mission/finds/find_book.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A place in a camera's picture.
struct PicturePoint {
    std::string sensor;                                 ///< StreamDescription::sensor
    Eigen::Vector2d share = Eigen::Vector2d(0.5, 0.5);  ///< of the picture's width and height, from top left
    std::uint64_t sequence = 0;                         ///< of the picture's event; 0: the newest
};

/// The evidence that shows a find, chosen from what a robot said.
struct ChosenEvidence {
    /// Everything but where the find is.
    FrozenEvidence frozen;
    /// Picture and pixel through which it is looked for; no picture: there is none of a calibrated camera.
    std::optional<Event> picture;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< [px]
    int width = 0, height = 0;                        ///< of that picture [px]
    double halfAngle = 0.0;                           ///< of what is meant, as seen [rad]
};

/// @p event as evidence of @p kind, as VictimEvidence has them.
[[nodiscard]] VictimEvidence evidenceOf(const char* kind, const Event& event);
/// Whether @p evidence is a picture.
[[nodiscard]] bool isPictureEvidence(const VictimEvidence& evidence);

/// The pictures of @p recent, also thermal ones, that are evidence of @p frozen and came since @p since.
[[nodiscard]] std::vector<Event> picturesOf(const FrozenEvidence& frozen, const RobotEvidence& recent,
                                            Time since);
/// @p frozen with no pictures but @p shown; heat only where a thermal one is among them.
[[nodiscard]] FrozenEvidence withPictures(FrozenEvidence frozen, const std::vector<Event>& shown);

/// Chooses of what @p robot said: of each camera the sharpest picture, of thermal cameras the newest with a
/// body, the CO2 of the last minute (of each second the highest, and the newest), newest scan, odometry and
/// sightings. The place is looked for through @p at where it is told (that picture is the one kept of its
/// camera: the robot may have moved since), else, where @p kind is a victim, through the hot spot, else
/// through the middle of the camera @p looksThrough. Takes some tens of milliseconds.
[[nodiscard]] ChosenEvidence chooseEvidence(const RobotDescription& robot, const RobotEvidence& recent,
                                            VictimSample::Kind kind, const std::string& looksThrough,
                                            const std::optional<PicturePoint>& at);

}  // namespace leitstand
