#pragma once

#include <cstddef>
#include <string>

#include "core/event/map_samples.h"

namespace leitstand::mapping_words {

// Messages to the operator about the map, in the window's language.

/// Asks whether a robot is at a place that is already in the map.
[[nodiscard]] std::string question();
/// Asks whether two parts of the map, whose relative pose is unknown, show the same place.
[[nodiscard]] std::string partsMeet();
/// Says that a loop closed, and that scans moved by up to @p largest [m].
[[nodiscard]] std::string met(double largest);
/// Says that a closed loop is no longer used.
[[nodiscard]] std::string contradicted();
/// Says how placing the robot called @p title ended.
[[nodiscard]] std::string place(const std::string& title, const RobotPlaceSample& place);
/// Says that a search for the robot called @p title failed: @p alike places of the map look like what it
/// sees.
[[nodiscard]] std::string lookedFor(const std::string& title, std::size_t alike);

/// Says that the measurements of the 3D scanner of the robot called @p title do not fit together.
[[nodiscard]] std::string scannerIsOff(const std::string& title);
/// Says that the 3D scanner of the robot called @p title is corrected from its next scan on, and in @p file;
/// empty: in no file.
[[nodiscard]] std::string scannerCorrected(const std::string& title, const std::string& file);
/// Says that the plane laser on @p topic of the robot called @p title makes the map from now on.
[[nodiscard]] std::string mapsByLaser(const std::string& title, const std::string& topic);
/// Says that the robot called @p title makes the map from the clouds on @p topic from now on.
[[nodiscard]] std::string mapsWith(const std::string& title, const std::string& topic);

}  // namespace leitstand::mapping_words
