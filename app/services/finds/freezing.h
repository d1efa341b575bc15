#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "app/services/finds/recent_evidence.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_book.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// A place in a camera's picture.
struct PicturePoint {
    std::string sensor;  ///< StreamDescription::sensor
    /// Shares of the picture's width and height, from the top left.
    Eigen::Vector2d share = Eigen::Vector2d(0.5, 0.5);
    std::uint64_t sequence = 0;  ///< sequence of the picture's event; 0: the newest picture
};

/// The evidence that shows a find, chosen from what a robot sent.
struct ChosenEvidence {
    /// Everything except the place of the find.
    FrozenEvidence frozen;
    /// Picture in which the place of the find is searched, at `pixel`. Empty: there is no picture from a
    /// calibrated camera, or the picture at which a person pointed is gone.
    std::optional<Event> picture;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();  ///< position in that picture [px]
    int width = 0, height = 0;                        ///< size of that picture [px]
    double halfAngle = 0.0;  ///< half the angle that the find spans in the camera [rad]
};

/// Returns @p event as evidence of @p kind, in the form of VictimEvidence.
[[nodiscard]] VictimEvidence evidenceOf(const char* kind, const Event& event);
/// Whether @p evidence is a picture.
[[nodiscard]] bool isPictureEvidence(const VictimEvidence& evidence);

/// Returns the pictures in @p recent, including thermal ones, that are evidence in @p frozen and were
/// received at @p since or later.
[[nodiscard]] std::vector<Event> picturesOf(const FrozenEvidence& frozen, const RobotEvidence& recent,
                                            Time since);
/// Returns @p frozen without the pictures that are not in @p shown. Its heat is kept only if a thermal
/// picture remains.
[[nodiscard]] FrozenEvidence withPictures(FrozenEvidence frozen, const std::vector<Event>& shown);

/// Chooses evidence from what @p robot sent:
/// - from each camera the sharpest picture,
/// - from each thermal camera the newest picture with a body, otherwise the newest picture,
/// - the CO2 of the last minute (the highest of each second, and the newest),
/// - the newest scan and the newest odometry.
///
/// If @p at is given, the place is searched there. Its picture is then also the one kept from its camera,
/// since the robot may have moved. Otherwise the place is searched at the hot spot if @p kind is a victim,
/// otherwise in the middle of the picture of the camera @p looksThrough. Takes some tens of milliseconds.
[[nodiscard]] ChosenEvidence chooseEvidence(const RobotDescription& robot, const RobotEvidence& recent,
                                            FindSample::Kind kind, const std::string& looksThrough,
                                            const std::optional<PicturePoint>& at);

}  // namespace leitstand
