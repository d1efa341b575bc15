#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/event/scan_links.h"
#include "core/mapping/live/live_settings.h"
#include "core/mapping/live/map/live_map.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {

/// Two scans that see the same place, and the resulting correction of the map around the later scan.
struct MatchedPlace {
    Link link;
    Pose correction = Pose::Identity();  ///< new pose in the map = correction * old pose
    /// Position of the later scan in the map, before the correction.
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    std::string robot;
    bool far = false;       ///< whether the later scan was found far from its pose in the map
    std::uint64_t met = 0;  ///< LiveKeyScan::part of the earlier scan
    /// At most 1: overlap minus three times the share of points in the other scan's free space.
    double fit = 0.0;

    /// Returns how far the correction moves the map at this place [m].
    [[nodiscard]] double shift() const { return (correction * at - at).norm(); }
};

/// Decides whether a scan sees the same as others. Registers it from coarse to fine, checks each scan's
/// points against the other's free space, and tries other places nearby.
class PlaceVerifier {
public:
    PlaceVerifier(const LoopSettings& loops, const MatchSettings& match, const FitSettings& fit)
        : m_loops(loops), m_match(match), m_fit(fit) {}

    /// Returns the place if @p scan, placed near @p guess, sees the same as @p local; empty: it does not.
    /// @p local: @p older and the scans around it.
    [[nodiscard]] std::optional<MatchedPlace> verify(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                     const LocalMap& local, const Pose& guess) const;
    /// Returns whether @p scan would fit about as well elsewhere, at most @p within [m] from its pose in the
    /// map. In a row of pillars or doors the nearest is not surely the right one. Places that fit equally
    /// well all along a corridor are ignored: nothing holds the scan there.
    [[nodiscard]] bool fitsBeside(const MatchedPlace& place, const LiveKeyScan& scan,
                                  const LiveKeyScan& older, const LocalMap& local, double within) const;

    /// Returns whether there can be another place within @p within [m] at all. If not, fitsBeside() need not
    /// be called.
    [[nodiscard]] static bool mayFitBeside(const MatchedPlace& place, double within);

private:
    LoopSettings m_loops;
    MatchSettings m_match;
    FitSettings m_fit;
};

}  // namespace leitstand
