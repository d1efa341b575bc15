#include <cmath>
#include <string>

#include "core/io/settings/score_file.h"
#include "core/mission/score/score.h"
#include "fuzz/input_file.h"

/// Rules of a score. What was read can be counted by.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace leitstand;
    const std::string text(reinterpret_cast<const char*>(data), size);
    const auto profile = parseScoreProfile(text, "score.json");
    if (!profile) return fuzz::requireNamed(profile.error(), "score.json");
    fuzz::require(!profile->name.empty(), "a name");
    for (const auto& [area, weight] : profile->areas) fuzz::require(std::isfinite(weight), "weights");
    for (const auto& [item, points] : profile->points) fuzz::require(std::isfinite(points), "points");
    fuzz::require(std::isfinite(profile->minutes) && profile->minutes >= 0.0, "a length");
    return 0;
}
