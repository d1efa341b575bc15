#pragma once

#include <cstdint>
#include <string_view>

#include "core/cloud/scan.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// A colour in OpenGL's memory layout.
struct Rgba {
    std::uint8_t r = 0, g = 0, b = 0, a = 255;

    bool operator==(const Rgba&) const = default;
};

/// Returns the colour of "#rrggbb".
[[nodiscard]] constexpr Rgba rgba(std::string_view hex) {
    const auto digit = [](char c) { return c <= '9' ? c - '0' : (c | 0x20) - 'a' + 10; };
    const auto byte = [&](std::size_t i) {
        return static_cast<std::uint8_t>(16 * digit(hex[i]) + digit(hex[i + 1]));
    };
    return {byte(1), byte(3), byte(5), 255};
}

/// Background and overlay colours of a map in one theme.
struct MapColours {
    Rgba background, text, muted, panel;  ///< panel: background of the legend and of the measurement's text
    Rgba grid;                            ///< includes its transparency
    Rgba ground;                          ///< floor points in the top view: the paper's light grey
    Rgba trail, scanPosition, markerEdge, measurement;
    Rgba uncertain;      ///< robots with an uncertain position
    Rgba uncertainScan;  ///< points and outline of an uncertain scan; no label has this hue
    /// The same for a scan that the operator is asked about, while everything else is dimmed().
    Rgba scanInQuestion;
    Rgba link, openLink, refusedLink;  ///< lines between scans that see the same place
    Rgba newThing, goneThing;  ///< changes since the earlier missions, while everything else is dimmed()
};
[[nodiscard]] const MapColours& mapColours(Theme theme);

/// Returns the paper's blue, yellow or red; grey for points without a label.
[[nodiscard]] Rgba labelColour(Label label);

/// Returns the colour for the scan with index @p scan. It comes from the colours of Okabe and Ito, which
/// colour-blind people can distinguish.
[[nodiscard]] Rgba scanColour(std::size_t scan);

/// Returns the colour of the robot at @p place in the team (from 0), which is also that of its pane and mark.
/// Grey when negative.
[[nodiscard]] Rgba robotColour(int place, Theme theme);

/// Returns the colour of the colour map viridis at @p t, clamped to 0..1. Its darkest end is left out, since
/// it is invisible on a dark screen.
[[nodiscard]] Rgba viridis(double t);

/// Returns @p colour mixed with @p other. @p share: share of @p other, 0 to 1.
[[nodiscard]] Rgba mixed(Rgba colour, Rgba other, double share);

/// Returns @p colour dimmed, as it is used for everything except the scan in question, or the changes.
[[nodiscard]] Rgba dimmed(Rgba colour, Theme theme);

/// Returns @p colour times @p factor, clamped.
[[nodiscard]] Rgba shaded(Rgba colour, double factor);

}  // namespace leitstand
