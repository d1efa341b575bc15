#pragma once

#include <QStringList>

namespace leitstand {

struct FindSample;
struct MissionState;

/// Returns texts that may be the tag of @p find. Those that were read nearest to it come first. They come
/// from filed codes and from codes that are still candidates.
[[nodiscard]] QStringList tagChoices(const MissionState& mission, const FindSample& find);

}  // namespace leitstand
