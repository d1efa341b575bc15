#include "core/cloud/shades.h"

#include <algorithm>
#include <cmath>

namespace leitstand {
namespace {

constexpr float ShadesAnOctave = 16.0F, OfShares = 255.0F;

}  // namespace

std::vector<std::uint8_t> shadesOf(const std::vector<float>& intensities) {
    const bool shares = std::none_of(intensities.begin(), intensities.end(),
                                     [](float intensity) { return intensity > 1.0F; });
    const float unit = shares ? OfShares : 1.0F;
    std::vector<std::uint8_t> shades(intensities.size());
    std::transform(intensities.begin(), intensities.end(), shades.begin(), [&](float intensity) {
        if (!(intensity > 0.0F)) return std::uint8_t{0};
        const float shade = ShadesAnOctave * std::log2(1.0F + unit * intensity);
        return static_cast<std::uint8_t>(std::clamp(std::round(shade), 0.0F, 255.0F));
    });
    return shades;
}

}  // namespace leitstand
