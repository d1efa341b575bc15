#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// How places of a map move when its scans do: each moves with the scan that was nearest to it before, since
/// that one saw it best.
class MovedPlaces {
public:
    /// Compares the poses of scans in @p before and @p after. Only scans that count in both move places.
    MovedPlaces(const LiveMap& before, const LiveMap& after);

    [[nodiscard]] bool any() const { return m_any; }
    /// Returns the correction at @p place (map's frame before the move [m]). It is put before poses there.
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
