#pragma once

#include <QStringList>

#include "core/mission/state/mission_state.h"

namespace leitstand {

/// What was read in the mission, on codes that were filed and on those that the station believes to have
/// seen: what may be @p find's tag, the nearest to it first.
[[nodiscard]] QStringList tagChoices(const MissionState& mission, const VictimSample& find);

}  // namespace leitstand
