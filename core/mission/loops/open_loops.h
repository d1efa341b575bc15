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
    std::uint64_t event = 0;                          ///< sequence of the event that reported it
    std::vector<Link> links;                          ///< not active, never empty
    bool parts = false;                               ///< it would join parts of the map that have not met
    Eigen::Vector3d at = Eigen::Vector3d::Zero();     ///< position of the later scan in the map [m]
    Eigen::Vector3d would = Eigen::Vector3d::Zero();  ///< position to which the links would move it [m]

    [[nodiscard]] double seam() const { return (would - at).norm(); }  ///< [m]
};

/// Returns the newest loop that waits for the operator's answer; empty: none does. A loop no longer waits
/// once its scans have moved to where its links want them.
[[nodiscard]] std::optional<OpenLoop> openLoop(const MissionState& state);

/// Returns the operator's answer to @p loop, for the log. With @p same, its scans are joined. Without, it is
/// another place that looks alike, and the operator is not asked about it again.
[[nodiscard]] ScanLinksSample answerTo(const OpenLoop& loop, bool same, const std::string& station, Time now);

}  // namespace leitstand
