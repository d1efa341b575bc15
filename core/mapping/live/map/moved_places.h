#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// How places of a map move when its scans do: each goes with the scan that stood nearest to it before, since
/// that one saw it best.
class MovedPlaces {
public:
    /// Scans of @p before that stand elsewhere in @p after; what is set aside moves nothing.
    MovedPlaces(const LiveMap& before, const LiveMap& after);

    [[nodiscard]] bool any() const { return m_any; }
    /// To put before poses at @p place, map's frame as it was [m].
    [[nodiscard]] Pose at(const Eigen::Vector3d& place) const;

private:
    struct Moved {
        Eigen::Vector3d was;
        Pose correction;
    };
    std::vector<Moved> m_scans;
    bool m_any = false;
};

}  // namespace leitstand
