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

/// Two scans that see the same place, and the correction of the map's part around the later one.
struct MatchedPlace {
    Link link;
    Pose correction = Pose::Identity();            ///< to be put before poses in the map
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< position of the later scan in the map, not corrected
    std::string robot;
    bool far = false;       ///< the later scan was found away from its pose in the map
    std::uint64_t met = 0;  ///< LiveKeyScan::part of the other scan
    double fit = 0.0;       ///< at most 1: overlap, less three times the share of points where the other scan
                            ///< looked through

    /// Returns how far the map would move there [m].
    [[nodiscard]] double shift() const { return (correction * at - at).norm(); }
};

/// Decides whether a scan sees the same as others. It registers the scan from coarse to fine, compares what
/// the scans looked through, and tries places beside the one that it found.
class PlaceVerifier {
public:
    PlaceVerifier(const LoopSettings& loops, const MatchSettings& match, const FitSettings& fit)
        : m_loops(loops), m_match(match), m_fit(fit) {}

    /// Returns the place if @p scan, roughly at @p guess, sees the same as @p local; empty: it does not.
    /// @p local: @p older and the scans around it.
    [[nodiscard]] std::optional<MatchedPlace> verify(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                     const LocalMap& local, const Pose& guess) const;
    /// Returns whether @p scan would fit about as well elsewhere, at most @p within [m] from its pose in the
    /// map. Among pillars or doors in a row the nearest is not surely the right one. A place that is the same
    /// all along a corridor does not count: nothing holds the scan there.
    [[nodiscard]] bool fitsBeside(const MatchedPlace& place, const LiveKeyScan& scan,
                                  const LiveKeyScan& older, const LocalMap& local, double within) const;

    /// Returns whether another place can be within @p within [m] at all; if not, fitsBeside() is not needed.
    [[nodiscard]] static bool mayFitBeside(const MatchedPlace& place, double within);

private:
    LoopSettings m_loops;
    MatchSettings m_match;
    FitSettings m_fit;
};

}  // namespace leitstand
