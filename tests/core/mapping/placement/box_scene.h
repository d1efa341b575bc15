#pragma once

#include <vector>

#include "core/base/pose.h"
#include "core/cloud/scan.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand::test {

/// Boxes on a level floor, as a turning 3D scanner sees them.
class BoxScene {
public:
    /// @p length along its heading, @p width across [m]; it stands on the floor about @p middle.
    void add(const Eigen::Vector2d& middle, double heading, double length, double width, double height);

    /// A turn at @p sensorInMap: 180 headings, 161 elevations from -80 to 80 degrees, noise of 1 cm.
    [[nodiscard]] Scan scan(const Pose& sensorInMap, unsigned seed = 1) const;
    /// What such a scan leaves in the map.
    [[nodiscard]] LocalMap map(const Pose& sensorInMap) const;

    static constexpr double Floor = -0.5;  ///< map frame [m]
    [[nodiscard]] static Pose scanner() { return poseFrom({0, 0, 0}, 0, 0, 0); }

private:
    struct Box {
        Pose inMap;  ///< its middle
        Eigen::Vector3d half;
    };
    std::vector<Box> m_boxes;
};

}  // namespace leitstand::test
