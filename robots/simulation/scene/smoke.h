#pragma once

#include <vector>

#include "robots/simulation/arena/arena.h"

namespace leitstand::simulation {

struct Ray;

/// The boxes of smoke in an arena.
class Smoke {
public:
    Smoke() = default;
    explicit Smoke(const Arena& arena);

    /// Returns whether smoke absorbs a laser's echo from @p distance along @p ray [m]. It does if the way
    /// through smoke is longer than the smoke's reach.
    [[nodiscard]] bool swallows(const Ray& ray, float distance) const;

private:
    struct Box {
        Eigen::Isometry3f arenaInBox = Eigen::Isometry3f::Identity();
        Eigen::Vector3f low = Eigen::Vector3f::Zero(), high = Eigen::Vector3f::Zero();
        float reach = 1.0F;  ///< how far a laser sees in this smoke [m]
    };
    std::vector<Box> m_boxes;
};

}  // namespace leitstand::simulation
