#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// One scan's points as input of the voxels.
struct VoxelSource {
    ScanPointsPtr points;
    Eigen::Matrix4d poseInMap;
    std::size_t scan = 0;  ///< index in the map
    Rgba colour = {};      ///< used when the scan decides the colour
    bool uncertain = false;

    bool operator==(const VoxelSource&) const = default;
};

/// Everything that determines the look of voxels.
struct VoxelRecipe {
    std::vector<VoxelSource> sources;
    double size = 0.1;  ///< edge [m]
    std::optional<double> minHeight, maxHeight;
    MapColouring colouring = MapColouring::Label;
    ColourRamp ramp;
    bool withCeiling = true;
    Theme theme = Theme::Dark;
    std::optional<std::size_t> inQuestion =
        {};                              ///< the uncertain scan to be decided on, as VoxelSource::scan
    bool changes = false;                ///< changes are shown: all else is dimmed()
    ScanPointsPtr came = {}, went = {};  ///< new and gone things, in the map's frame [m]; null: none

    bool operator==(const VoxelRecipe&) const = default;
};

/// Builds cubes around all points within the recipe's heights. A cube has the colour of most of its points
/// (label, scan, robot, age), or that of its height or of the mean range or intensity. Faces are shaded by
/// direction and darker in corners, so that they stand apart. Cubes that only uncertain scans saw, and cubes
/// of new or gone things, have the colours for these. Empty when @p interrupted returned true.
[[nodiscard]] std::optional<VoxelMesh> buildVoxels(const VoxelRecipe& recipe,
                                                   const std::function<bool()>& interrupted);

}  // namespace leitstand
