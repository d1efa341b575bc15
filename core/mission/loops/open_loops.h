#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/event/scan_links.h"

namespace leitstand {

struct MissionState;

/// A place where the map may meet itself; the operator decides whether it does.
struct OpenLoop {
    std::uint64_t event = 0;                          ///< sequence of the event that reported it
    std::vector<Link> links;                          ///< not active, never empty
    bool parts = false;                               ///< it would join parts of the map that have not met
    Eigen::Vector3d at = Eigen::Vector3d::Zero();     ///< position of the later scan in the map [m]
    Eigen::Vector3d would = Eigen::Vector3d::Zero();  ///< position to which the links would move it [m]

    [[nodiscard]] double seam() const { return (would - at).norm(); }  ///< [m]
};

/// Returns the newest loop that waits for an answer; empty: none does. Loops whose places came together since
/// are not asked about any more.
[[nodiscard]] std::optional<OpenLoop> openLoop(const MissionState& state);

/// Returns the operator's answer to @p loop. @p same: its scans are put together; otherwise it is another
/// place that looks alike. It is not asked about again.
[[nodiscard]] ScanLinksSample answerTo(const OpenLoop& loop, bool same, const std::string& station, Time now);

}  // namespace leitstand
