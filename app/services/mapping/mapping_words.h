#pragma once

#include <cstddef>
#include <string>

#include "core/event/map_samples.h"

namespace leitstand::mapping_words {

// What the operator is told about the map, in the window's language.

/// The map may meet itself, and asks.
[[nodiscard]] std::string question();
/// Two parts of it, of which nobody knew how they lie to each other, may have seen one place, and it asks.
[[nodiscard]] std::string partsMeet();
/// A loop closed; scans moved by up to @p largest [m].
[[nodiscard]] std::string met(double largest);
/// A closed loop does not count any more.
[[nodiscard]] std::string contradicted();
/// How it went with the place of the robot of this @p title.
[[nodiscard]] std::string place(const std::string& title, const RobotPlaceSample& place);
/// It was looked for in the whole map in vain: @p alike places look as what it sees.
[[nodiscard]] std::string lookedFor(const std::string& title, std::size_t alike);

/// The map finds the scanner of the robot of this @p title to be off.
[[nodiscard]] std::string scannerIsOff(const std::string& title);
/// It is corrected from now on, also in @p file, if any.
[[nodiscard]] std::string scannerCorrected(const std::string& title, const std::string& file);

}  // namespace leitstand::mapping_words
