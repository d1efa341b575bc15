#pragma once

#include <QStringList>

namespace leitstand {

struct FindSample;
struct MissionState;

/// Returns the texts that may be @p find's tag, the nearest to it first. They come from filed codes and from
/// codes that the station believes to have seen.
[[nodiscard]] QStringList tagChoices(const MissionState& mission, const FindSample& find);

}  // namespace leitstand
