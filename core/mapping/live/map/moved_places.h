#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/mapping/live/map/live_map.h"

namespace leitstand {

/// How places of a map move when its scans move. Each place moves with the scan that was nearest to it
/// before, since that scan saw it best.
class MovedPlaces {
public:
    /// Compares the poses of scans in @p before and @p after. Scans that are uncertain or set aside in either
    /// map move no places.
    MovedPlaces(const LiveMap& before, const LiveMap& after);

    [[nodiscard]] bool any() const { return m_any; }
    /// Returns the correction at @p place (map's frame before the move [m]): new pose = correction * old
    /// pose.
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
