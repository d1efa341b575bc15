#pragma once

#include <cstddef>
#include <string>

#include "core/event/map_samples.h"

namespace leitstand::mapping_words {

// Messages to the operator about the map, in the window's language.

/// Asks whether the map meets itself: whether a robot is at a place that the map has seen before.
[[nodiscard]] std::string question();
/// Asks whether two parts of the map, whose relative pose is unknown, have seen the same place.
[[nodiscard]] std::string partsMeet();
/// A loop closed; scans moved by up to @p largest [m].
[[nodiscard]] std::string met(double largest);
/// A closed loop does not count any more.
[[nodiscard]] std::string contradicted();
/// The outcome of placing the robot of this @p title.
[[nodiscard]] std::string place(const std::string& title, const RobotPlaceSample& place);
/// A search for the robot of this @p title failed: @p alike places of the map look like what it sees.
[[nodiscard]] std::string lookedFor(const std::string& title, std::size_t alike);

/// The measurements of the 3D scanner of the robot of this @p title do not fit together.
[[nodiscard]] std::string scannerIsOff(const std::string& title);
/// The 3D scanner of the robot of this @p title is corrected from its next scan on, and in @p file; empty: in
/// none.
[[nodiscard]] std::string scannerCorrected(const std::string& title, const std::string& file);
/// The map of the robot of this @p title is made from the clouds on @p topic from now on.
[[nodiscard]] std::string mapsByLaser(const std::string& title, const std::string& topic);
[[nodiscard]] std::string mapsWith(const std::string& title, const std::string& topic);

}  // namespace leitstand::mapping_words
