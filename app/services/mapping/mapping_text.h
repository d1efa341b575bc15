#pragma once

#include <cstddef>
#include <string>

#include "core/event/map_samples.h"

namespace leitstand::mapping_words {

// Messages to the operator about the map, in the window's language.

/// The map may meet itself; asks whether it does.
[[nodiscard]] std::string question();
/// Two parts of the map with unknown relative pose may have seen one place; asks whether they did.
[[nodiscard]] std::string partsMeet();
/// A loop closed; scans moved by up to @p largest [m].
[[nodiscard]] std::string met(double largest);
/// A closed loop does not count any more.
[[nodiscard]] std::string contradicted();
/// The outcome of placing the robot of this @p title.
[[nodiscard]] std::string place(const std::string& title, const RobotPlaceSample& place);
/// A search for the robot in the whole map failed: @p alike places look like what it sees.
[[nodiscard]] std::string lookedFor(const std::string& title, std::size_t alike);

/// The measurements of the 3D scanner of the robot of this @p title do not fit together.
[[nodiscard]] std::string scannerIsOff(const std::string& title);
/// Its scanner is corrected from now on, also in @p file, if any.
[[nodiscard]] std::string scannerCorrected(const std::string& title, const std::string& file);

}  // namespace leitstand::mapping_words
