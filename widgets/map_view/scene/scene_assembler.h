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

/// A request for a scene.
struct SceneOrder {
    std::uint64_t number = 0;
    MapPtr map;                                 ///< null: show nothing
    std::vector<bool> scanIsVisible;            ///< scans beyond the end are visible
    std::uint64_t highlighted = 0;              ///< MapScan::id of the highlighted scan; 0: none
    std::map<std::uint64_t, Pose> ghosts;       ///< given to MapView::setGhosts() or MapView::setDragged()
    bool dragged = false;                       ///< whether the ghosts were given to MapView::setDragged()
    std::shared_ptr<const MapChanges> changes;  ///< given to MapView::setChanges(); null: none are shown
    MapViewSettings settings;
    std::vector<SceneRobot> robots;  ///< robots of the team
};

/// Makes the content to draw for a map, and keeps what can be used again. One thread.
class SceneAssembler {
public:
    /// Returns the content for @p order; null when @p interrupted returned true. From time to time calls
    /// @p onPart with the part that is ready.
    [[nodiscard]] SceneContentPtr assemble(const SceneOrder& order, const std::function<bool()>& interrupted,
                                           const std::function<void(SceneContentPtr)>& onPart);

private:
    /// A prepared scan, and the settings from which it was made.
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
    std::shared_ptr<const MapChanges> m_changed;     ///< changes from which m_changedPoints were made
    std::array<ScanPointsPtr, 2> m_changedPoints;
    VoxelRecipe m_recipe;
    std::shared_ptr<const VoxelMesh> m_voxels;
};

}  // namespace leitstand
