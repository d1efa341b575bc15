#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "robots/simulation/world/motion/feelers.h"

namespace leitstand::simulation {

/// Distinguishes new contacts from contacts that continue. A contact ends when it was not felt for half a
/// second.
class BumpCounter {
public:
    /// Returns whether @p obstacle is a new contact at @p now. Walls that meet and face the same way are
    /// treated as one.
    [[nodiscard]] bool isNew(const Obstacle& obstacle, Time now);

private:
    struct Contact {
        int element, body;
        bool victim;
        Eigen::Vector2d normal;  ///< in the arena's frame
        Time last;
    };
    std::vector<Contact> m_contacts;
};

}  // namespace leitstand::simulation
