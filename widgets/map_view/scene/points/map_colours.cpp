#include "widgets/map_view/scene/points/map_colours.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/painting/theme.h"

namespace leitstand {

const MapColours& mapColours(Theme theme) {
    static constexpr MapColours Dark = {
        .background = rgba("#12151A"),
        .text = rgba("#E6E9EF"),
        .muted = rgba("#9AA3B2"),
        .panel = {0x16, 0x1A, 0x20, 224},
        .grid = {0x6B, 0x76, 0x89, 96},
        .ground = rgba("#C6CBD3"),
        .trail = rgba("#CC79A7"),
        .scanPosition = rgba("#2F62EE"),
        .markerEdge = rgba("#FFFFFF"),
        .measurement = rgba("#56B4E9"),
        .uncertain = rgba("#E69F00"),
        .uncertainScan = rgba("#A22BDC"),
        .scanInQuestion = rgba("#E2A6FF"),
        .link = rgba("#2FD39A"),
        .openLink = rgba("#FFB000"),
        .refusedLink = rgba("#FF6A5A"),
        .newThing = rgba("#FF8A1F"),
        .goneThing = rgba("#35C8F5"),
    };
    static constexpr MapColours Light = {
        .background = rgba("#F3F4F6"),
        .text = rgba("#12151A"),
        .muted = rgba("#535D6E"),
        .panel = {0xFF, 0xFF, 0xFF, 232},
        .grid = {0x53, 0x5D, 0x6E, 80},
        .ground = rgba("#B4BAC4"),
        .trail = rgba("#B0578A"),
        .scanPosition = rgba("#2F62EE"),
        .markerEdge = rgba("#FFFFFF"),
        .measurement = rgba("#0072B2"),
        .uncertain = rgba("#A86200"),
        .uncertainScan = rgba("#A22BDC"),
        .scanInQuestion = rgba("#7A14A8"),
        .link = rgba("#00805A"),
        .openLink = rgba("#A86200"),
        .refusedLink = rgba("#B3261E"),
        .newThing = rgba("#C24A00"),
        .goneThing = rgba("#006FB0"),
    };
    return theme == Theme::Dark ? Dark : Light;
}

Rgba labelColour(Label label) {
    switch (label) {
        case Label::Floor:
            return rgba("#4084E0");
        case Label::Wall:
            return rgba("#E8C410");
        case Label::Ceiling:
            return rgba("#D64E4A");
        case Label::Unlabelled:
            break;
    }
    return rgba("#8A93A3");
}

Rgba robotColour(int place, Theme theme) {
    if (place < 0) return labelColour(Label::Unlabelled);
    const QColor& colour = coloursOf(theme).robot(place);
    return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
            static_cast<std::uint8_t>(colour.blue()), 255};
}

Rgba scanColour(std::size_t scan) {
    static constexpr std::array<Rgba, 7> OkabeIto = {
        rgba("#56B4E9"), rgba("#E69F00"), rgba("#009E73"), rgba("#CC79A7"),
        rgba("#F0E442"), rgba("#D55E00"), rgba("#0072B2"),
    };
    return OkabeIto[scan % OkabeIto.size()];
}

Rgba viridis(double t) {
    static constexpr std::array<Rgba, 10> Steps = {
        rgba("#440154"), rgba("#482878"), rgba("#3E4A89"), rgba("#31688E"), rgba("#26828E"),
        rgba("#1F9E89"), rgba("#35B779"), rgba("#6DCD59"), rgba("#B4DE2C"), rgba("#FDE725"),
    };
    constexpr double Darkest = 0.13;
    const double shown = Darkest + (1.0 - Darkest) * std::clamp(t, 0.0, 1.0);
    const double position = shown * static_cast<double>(Steps.size() - 1);
    const auto lower = std::min(static_cast<std::size_t>(position), Steps.size() - 2);
    const double weight = position - static_cast<double>(lower);
    return mixed(Steps[lower], Steps[lower + 1], weight);
}

Rgba mixed(Rgba colour, Rgba other, double share) {
    const auto mix = [share](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround((1.0 - share) * a + share * b));
    };
    return {mix(colour.r, other.r), mix(colour.g, other.g), mix(colour.b, other.b), colour.a};
}

Rgba dimmed(Rgba colour, Theme theme) {
    constexpr double Share = 0.7;
    return mixed(colour, mapColours(theme).background, Share);
}

Rgba shaded(Rgba colour, double factor) {
    const auto scale = [factor](std::uint8_t value) {
        return static_cast<std::uint8_t>(std::clamp(std::lround(value * factor), 0L, 255L));
    };
    return {scale(colour.r), scale(colour.g), scale(colour.b), colour.a};
}

}  // namespace leitstand
