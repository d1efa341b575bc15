#pragma once

#include <cstdint>
#include <optional>

namespace leitstand {

/// How the map is drawn, as in Figure 4 of the paper: as points, as voxels, or from the top.
enum class MapLook : std::uint8_t { Points, Voxels, Top };

/// Whether the camera follows the selected robot. While it does, ceilings are hidden.
enum class MapFollow : std::uint8_t {
    Free,
    Behind,  ///< from behind and above
    Above,   ///< from straight above, with the robot's heading up
};

/// How the map is viewed, as far as a layout decides it.
struct MapSight {
    MapLook look = MapLook::Points;
    MapFollow follow = MapFollow::Free;
    bool operator==(const MapSight&) const = default;
};

/// View of the map that a layout asks for. Where a value is empty, the operator decides.
struct LayoutMap {
    std::optional<MapLook> look = std::nullopt;
    std::optional<MapFollow> follow = std::nullopt;

    [[nodiscard]] bool isMeaningful() const { return look || follow; }
};

}  // namespace leitstand
