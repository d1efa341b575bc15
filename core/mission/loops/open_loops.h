#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/event/scan_links.h"

namespace leitstand {

struct MissionState;

/// A place where the map may close a loop; the operator decides whether it does.
struct OpenLoop {
    std::uint64_t event = 0;  ///< sequence of the event that reported the loop
    std::vector<Link> links;  ///< links that would close it: not active, never empty
    bool parts = false;       ///< whether it would join parts of the map that are not joined yet
    Eigen::Vector3d at = Eigen::Vector3d::Zero();     ///< position of the later scan in the map [m]
    Eigen::Vector3d would = Eigen::Vector3d::Zero();  ///< position of that scan if the links were active [m]

    [[nodiscard]] double seam() const { return (would - at).norm(); }  ///< how far that scan would move [m]
};

/// Returns the newest loop that waits for the operator's answer; empty: none. A loop no longer waits when its
/// scans already have about the poses that its links require.
[[nodiscard]] std::optional<OpenLoop> openLoop(const MissionState& state);

/// Returns the operator's answer to @p loop, for the log. @p same: the two places are the same, and the scans
/// are joined. Otherwise they only look alike, and the operator is not asked about this loop again.
[[nodiscard]] ScanLinksSample answerTo(const OpenLoop& loop, bool same, const std::string& station, Time now);

}  // namespace leitstand
