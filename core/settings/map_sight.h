#pragma once

#include <cstdint>
#include <optional>

namespace leitstand {

/// How the map is drawn, as in Figure 4 of the paper: as points, as voxels, or from the top.
enum class MapLook : std::uint8_t { Points, Voxels, Top };

/// Whether the camera follows the selected robot. While it does, ceilings are hidden.
enum class MapFollow : std::uint8_t {
    Free,
    Behind,  ///< the camera is behind and above the robot
    Above,   ///< the camera is straight above, with the robot's heading up
};

/// How the map is viewed, as far as a layout determines it.
struct MapSight {
    MapLook look = MapLook::Points;
    MapFollow follow = MapFollow::Free;
    bool operator==(const MapSight&) const = default;
};

/// View of the map in a layout. The operator decides about values that are empty.
struct LayoutMap {
    std::optional<MapLook> look = std::nullopt;
    std::optional<MapFollow> follow = std::nullopt;

    [[nodiscard]] bool isMeaningful() const { return look || follow; }
};

}  // namespace leitstand
