#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// One scan's points on their way into voxels.
struct VoxelSource {
    ScanPointsPtr points;
    Eigen::Matrix4d poseInMap;
    std::size_t scan = 0;  ///< position in the map
    Rgba colour = {};      ///< where the scan decides that
    bool uncertain = false;

    bool operator==(const VoxelSource&) const = default;
};

/// All that decides how voxels look.
struct VoxelRecipe {
    std::vector<VoxelSource> sources;
    double size = 0.1;  ///< edge [m]
    std::optional<double> minHeight, maxHeight;
    MapColouring colouring = MapColouring::Label;
    ColourRamp ramp;
    bool withCeiling = true;
    Theme theme = Theme::Dark;
    std::optional<std::size_t> inQuestion =
        {};                              ///< the uncertain scan that is decided on, as VoxelSource::scan
    bool changes = false;                ///< what changed is shown: all else is dimmed()
    ScanPointsPtr came = {}, went = {};  ///< in the map's frame; null: none

    bool operator==(const VoxelRecipe&) const = default;
};

/// Cubes around all points within the recipe's heights. A cube has the colour of most of its points (label,
/// scan, robot, age), of its height or of their mean range or intensity; its faces are shaded by their
/// direction and darker in corners, so that they can be told apart. Those in which only uncertain scans have
/// points have their colour, and those where something came or went have that of it. Nothing when @p
/// interrupted said to stop.
[[nodiscard]] std::optional<VoxelMesh> buildVoxels(const VoxelRecipe& recipe,
                                                   const std::function<bool()>& interrupted);

}  // namespace leitstand
