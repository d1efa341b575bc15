#pragma once

#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/mission/mission_state.h"
#include "core/robot/samples/station_samples.h"

namespace leitstand {

/// Takes back the newest of the operator's decisions on scans that @p station made and that is not taken back
/// yet; empty: there is none.
[[nodiscard]] std::optional<UndoSample> undoOfScans(const MissionState& state, const std::string& station,
                                                    Time now);
/// Does again what undoOfScans() took back last; empty: nothing was, or the operator decided something since.
[[nodiscard]] std::optional<UndoSample> redoOfScans(const MissionState& state, const std::string& station,
                                                    Time now);

}  // namespace leitstand
