#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// One scan's points, as input for voxels.
struct VoxelSource {
    ScanPointsPtr points;
    Eigen::Matrix4d poseInMap;
    std::size_t scan = 0;  ///< index of the scan in the map
    Rgba colour = {};      ///< used if the scan determines the colour
    bool uncertain = false;

    bool operator==(const VoxelSource&) const = default;
};

/// Everything that determines how voxels look.
struct VoxelRecipe {
    std::vector<VoxelSource> sources;
    double size = 0.1;  ///< edge [m]
    std::optional<double> minHeight, maxHeight;
    MapColouring colouring = MapColouring::Label;
    ColourRamp ramp;
    bool withCeiling = true;
    Theme theme = Theme::Dark;
    std::optional<std::size_t> inQuestion =
        {};                ///< VoxelSource::scan of the uncertain scan that the operator is asked about
    bool changes = false;  ///< whether changes are shown; then everything else is dimmed()
    /// New things, and things that have disappeared, in the map's frame [m]; null: none.
    ScanPointsPtr came = {}, went = {};

    bool operator==(const VoxelRecipe&) const = default;
};

/// Builds cubes around all points within the recipe's heights. A cube has the colour of most of its points
/// (label, scan, robot, age), or that of its height or of the mean range or intensity. Faces are shaded by
/// direction and darker in corners, so that they can be distinguished. Cubes that only uncertain scans saw,
/// and cubes of changed things, have special colours. Empty when @p interrupted returned true.
[[nodiscard]] std::optional<VoxelMesh> buildVoxels(const VoxelRecipe& recipe,
                                                   const std::function<bool()>& interrupted);

}  // namespace leitstand
