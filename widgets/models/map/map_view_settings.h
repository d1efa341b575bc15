#pragma once

#include <cstdint>
#include <optional>

#include "core/settings/map_sight.h"

namespace leitstand {

/// What the colour of a point shows.
enum class MapColouring : std::uint8_t { Label, Scan, Height, Range, Robot, Intensity, Age };

/// Which poses are shown.
enum class MapPoses : std::uint8_t { Registered, Guess };

enum class CameraPreset : std::uint8_t { Reset, Top, Side };

enum class Theme : std::uint8_t { Dark, Light };

/// How the map is drawn.
struct MapViewSettings {
    MapLook look = MapLook::Points;
    MapColouring colouring = MapColouring::Label;
    MapPoses poses = MapPoses::Registered;
    double voxelSize = 0.10;                         ///< edge of a voxel, 0.05 to 0.5 [m]
    std::optional<double> minHeight = std::nullopt;  ///< points below are hidden, in the map's frame [m]
    std::optional<double> maxHeight = std::nullopt;  ///< points above are hidden, in the map's frame [m]
    /// Points nearer to their scanner (the robot itself) or farther from it ("no echo") are never drawn [m].
    double minRange = 0.4, maxRange = 30.0;
    Theme theme = Theme::Dark;
    MapFollow follow = MapFollow::Free;

    /// Whether ceilings are drawn, which hide what is below them.
    [[nodiscard]] bool withCeiling() const { return look != MapLook::Top && follow == MapFollow::Free; }
    bool operator==(const MapViewSettings&) const = default;
};

}  // namespace leitstand
