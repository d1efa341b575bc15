#include "core/perception/heat/heat_picture.h"

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

}  // namespace

std::array<std::uint8_t, 3> inferno(double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (Inferno.size() - 1);
    const auto lower = std::min(static_cast<std::size_t>(place), Inferno.size() - 2);
    const double rest = place - static_cast<double>(lower);
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t i = 0; i < colour.size(); ++i) {
        const double value = (1.0 - rest) * Inferno[lower][i] + rest * Inferno[lower + 1][i];
        colour[i] = static_cast<std::uint8_t>(std::lround(value));
    }
    return colour;
}

Picture heatPicture(const ThermalPicture& heat, double coldest, double hottest) {
    Picture picture{.width = heat.width, .height = heat.height, .pixel = Picture::Pixel::Rgb8, .bytes = {}};
    picture.bytes.reserve(3 * heat.celsius.size());
    for (const float celsius : heat.celsius) {
        constexpr std::array<std::uint8_t, 3> Unmeasured = {128, 128, 128};
        const double share = (static_cast<double>(celsius) - coldest) / (hottest - coldest);
        for (const std::uint8_t value : std::isnan(share) ? Unmeasured : inferno(share))
            picture.bytes.push_back(std::byte{value});
    }
    return picture;
}

}  // namespace leitstand
