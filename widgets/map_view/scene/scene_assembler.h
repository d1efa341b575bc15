#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

#include "core/mapping/comparison/map_changes.h"
#include "core/mapping/map.h"
#include "widgets/map_view/scene/scene_content.h"
#include "widgets/map_view/scene/voxel_mesh.h"

namespace leitstand {

/// The request for a scene.
struct SceneOrder {
    std::uint64_t number = 0;
    MapPtr map;                                 ///< null: nothing
    std::vector<bool> scanIsVisible;            ///< scans beyond the end are visible
    std::uint64_t highlighted = 0;              ///< MapScan::id of the highlighted scan; 0: none
    std::map<std::uint64_t, Pose> ghosts;       ///< of MapView::setGhosts() or MapView::setDragged()
    bool dragged = false;                       ///< the ghosts are those of MapView::setDragged()
    std::shared_ptr<const MapChanges> changes;  ///< MapView::setChanges(); null: none are shown
    MapViewSettings settings;
    std::vector<SceneRobot> robots;  ///< of the team
};

/// Makes the drawn content of a map, and keeps what can be reused. One thread.
class SceneAssembler {
public:
    /// Returns the content for @p order, or null when @p interrupted returned true. Calls @p onPart from time
    /// to time with the part that is ready.
    [[nodiscard]] SceneContentPtr assemble(const SceneOrder& order, const std::function<bool()>& interrupted,
                                           const std::function<void(SceneContentPtr)>& onPart);

private:
    /// A scan made ready, and the settings it depends on.
    struct Ready {
        ScanPtr scan;
        double minRange = 0.0, maxRange = 0.0;
        ScanPointsPtr points;
    };

    void forgetAllBut(const Map& map);
    const ScanPointsPtr& pointsFor(const ScanPtr& scan, const MapViewSettings& settings);
    void addGhosts(SceneContent& content, const SceneOrder& order);
    void addChanges(SceneContent& content, const SceneOrder& order);
    [[nodiscard]] bool addVoxels(SceneContent& content, const std::function<bool()>& interrupted);

    std::unordered_map<const Scan*, Ready> m_ready;  ///< owns the scans
    std::shared_ptr<const MapChanges> m_changed;     ///< changes that m_changedPoints are made of
    std::array<ScanPointsPtr, 2> m_changedPoints;
    VoxelRecipe m_recipe;
    std::shared_ptr<const VoxelMesh> m_voxels;
};

}  // namespace leitstand
