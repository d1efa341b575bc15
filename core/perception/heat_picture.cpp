#include "core/perception/heat_picture.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace leitstand {
namespace {

using Colour = std::array<double, 3>;
/// Matplotlib's inferno at nine places, evenly apart.
constexpr std::array<Colour, 9> Inferno = {{{0, 0, 4},
                                            {31, 12, 72},
                                            {85, 15, 109},
                                            {136, 34, 106},
                                            {186, 54, 85},
                                            {227, 89, 51},
                                            {249, 140, 10},
                                            {249, 201, 50},
                                            {252, 255, 164}}};

Colour colourOf(double share) {
    if (std::isnan(share)) return {128, 128, 128};
    const double place = std::clamp(share, 0.0, 1.0) * (Inferno.size() - 1);
    const auto lower = std::min(static_cast<std::size_t>(place), Inferno.size() - 2);
    const double rest = place - static_cast<double>(lower);
    Colour colour{};
    for (std::size_t i = 0; i < 3; ++i)
        colour[i] = Inferno[lower][i] + rest * (Inferno[lower + 1][i] - Inferno[lower][i]);
    return colour;
}

}  // namespace

Picture heatPicture(const ThermalPicture& heat, double coldest, double hottest) {
    Picture picture{.width = heat.width, .height = heat.height, .pixel = Picture::Pixel::Rgb8, .bytes = {}};
    picture.bytes.reserve(3 * heat.celsius.size());
    for (const float celsius : heat.celsius) {
        for (const double value : colourOf((static_cast<double>(celsius) - coldest) / (hottest - coldest)))
            picture.bytes.push_back(std::byte{static_cast<unsigned char>(std::lround(value))});
    }
    return picture;
}

}  // namespace leitstand
