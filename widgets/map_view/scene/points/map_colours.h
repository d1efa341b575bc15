#pragma once

#include <cstdint>
#include <string_view>

#include "core/cloud/scan.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// A colour as it lies in OpenGL's memory.
struct Rgba {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;

    bool operator==(const Rgba&) const = default;
};

/// "#rrggbb".
[[nodiscard]] constexpr Rgba rgba(std::string_view hex) {
    const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint8_t>(16 * digit(hex[i]) + digit(hex[i + 1]));
    };
    return {byte(1), byte(3), byte(5), 255};
}

/// Background and overlay colours of a map in one theme.
struct MapColours {
    Rgba background, text, muted, panel;  ///< panel: behind the legend and the measurement's text
    Rgba grid;                            ///< with its transparency
    Rgba ground;                          ///< floor points in the top view: the paper's light grey
    Rgba trail, scanPosition, markerEdge, measurement;
    Rgba uncertain;                    ///< of robots: look here
    Rgba uncertainScan;                ///< of its points and its outline: no label has that hue
    Rgba scanInQuestion;               ///< likewise, while it is decided on and all else is dimmed()
    Rgba link, openLink, refusedLink;  ///< lines between scans that see the same place
    Rgba newThing, goneThing;          ///< since the missions before, while all else is dimmed()
};
[[nodiscard]] const MapColours& mapColours(Theme theme);

/// The paper's blue, yellow and red; grey for points without a label.
[[nodiscard]] Rgba labelColour(Label label);

/// The @p scan-th colour of Okabe and Ito's cycle, which colour-blind people can tell apart.
[[nodiscard]] Rgba scanColour(std::size_t scan);

/// Of the @p place -th robot of the team, as its pane and its mark have it; grey for negative ones.
[[nodiscard]] Rgba robotColour(int place, Theme theme);

/// The colour map viridis, without its darkest end that is not seen on a dark screen, at @p t, cut to 0..1.
[[nodiscard]] Rgba viridis(double t);

/// @p share of @p other in @p colour, 0 to 1.
[[nodiscard]] Rgba mixed(Rgba colour, Rgba other, double share);

/// @p colour while a scan is decided on that it does not belong to.
[[nodiscard]] Rgba dimmed(Rgba colour, Theme theme);

/// @p colour times @p factor, without overflow.
[[nodiscard]] Rgba shaded(Rgba colour, double factor);

}  // namespace leitstand
