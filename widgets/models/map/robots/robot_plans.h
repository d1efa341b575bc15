#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/mission/state/robot_state.h"

namespace leitstand {

struct RobotInMap;

/// Paths that a robot plans to take, each from its beginning, in the map's frame [m].
using PlannedPaths = std::vector<std::vector<Eigen::Vector3d>>;

/// Keeps the planned paths of one robot as they lie in the map.
class RobotPlans {
public:
    /// Returns the paths that count at @p now, station's clock; null: none. A path counts no longer when the
    /// robot is at its end, or when none came for a minute: planners do not say that a path is done. Paths
    /// whose frame no tf joins with the odometry's are left out. The same pointer comes again as long as
    /// nothing moves by a centimetre.
    [[nodiscard]] std::shared_ptr<const PlannedPaths> at(const RobotState& robot, const RobotInMap& place,
                                                         Time now);

    static constexpr double AtItsEnd = 0.5;  ///< [m]
    static constexpr std::chrono::seconds Lasts{60};

private:
    /// A path and where its frame lay when it was drawn.
    struct Drawn {
        LatestPtr<PathSample> path;
        Pose frameInMap = Pose::Identity();
    };
    std::vector<Drawn> m_drawn;
    std::shared_ptr<const PlannedPaths> m_paths;
};

}  // namespace leitstand
