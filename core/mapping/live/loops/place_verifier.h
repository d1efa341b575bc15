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

/// Two scans that see the same place, and by what the map's part about the later one would move.
struct MatchedPlace {
    Link link;
    Pose correction = Pose::Identity();            ///< to put before poses, in the map
    Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< where the map has the later one
    std::string robot;
    bool far = false;       ///< it was not looked for where the map has it
    std::uint64_t met = 0;  ///< LiveKeyScan::part of the other scan
    double fit = 0.0;       ///< at most 1: overlap, less what stands where the other one looked through

    /// By how much the map would move there [m].
    [[nodiscard]] double shift() const { return (correction * at - at).norm(); }
};

/// Decides whether a scan sees what others saw: by registration from coarse to fine, by what they looked
/// through, and by what lies beside.
class PlaceVerifier {
public:
    PlaceVerifier(const LoopSettings& loops, const MatchSettings& match, const FitSettings& fit)
        : m_loops(loops), m_match(match), m_fit(fit) {}

    /// Whether @p scan, roughly at @p guess, sees what @p older and the scans about it, @p local, have seen.
    [[nodiscard]] std::optional<MatchedPlace> verify(const LiveKeyScan& scan, const LiveKeyScan& older,
                                                     const LocalMap& local, const Pose& guess) const;
    /// Whether @p scan would fit about as well somewhere else, at most @p within [m] from where it stands:
    /// among pillars or doors in a row the nearest is not surely the right one. What is the same all along a
    /// corridor is no other place: nothing holds the scan there.
    [[nodiscard]] bool fitsBeside(const MatchedPlace& place, const LiveKeyScan& scan,
                                  const LiveKeyScan& older, const LocalMap& local, double within) const;

    /// Whether anything lies so near that this could be; else it need not be asked.
    [[nodiscard]] static bool mayFitBeside(const MatchedPlace& place, double within);

private:
    LoopSettings m_loops;
    MatchSettings m_match;
    FitSettings m_fit;
};

}  // namespace leitstand
