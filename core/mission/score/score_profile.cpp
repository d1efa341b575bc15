#include "core/mission/score/score_profile.h"

namespace leitstand {

const char* toString(ScoreItem item) {
    constexpr const char* Names[] = {"map",   "location", "form",      "motion", "heat",
                                     "sound", "co2",      "situation", "tag"};
    return Names[static_cast<std::size_t>(item)];
}

}  // namespace leitstand
