#pragma once

#include <string>
#include <vector>

#include "core/mission/state/mission_state.h"

namespace leitstand::test {

/// All that @p state holds, a line "path = value" for each value, in an order of its own. Numbers have nine
/// digits, times are nanoseconds since the Unix epoch, enumerations are numbers as they stand in files.
[[nodiscard]] std::vector<std::string> stateText(const MissionState& state);

}  // namespace leitstand::test
