#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/base/time.h"
#include "core/event/scan_links.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// A place where the map may meet itself, of which the operator is to say whether it does.
struct OpenLoop {
    std::uint64_t event = 0;                          ///< sequence that told it
    std::vector<Link> links;                          ///< not active, never empty
    bool parts = false;                               ///< it would join parts of the map that have not met
    Eigen::Vector3d at = Eigen::Vector3d::Zero();     ///< where the later scan is, map's frame [m] ...
    Eigen::Vector3d would = Eigen::Vector3d::Zero();  ///< ... and where the links want it

    [[nodiscard]] double seam() const { return (would - at).norm(); }  ///< [m]
};

/// The newest that waits for an answer; empty: none does. What moved since may have brought two places
/// together: those are not asked about any more.
[[nodiscard]] std::optional<OpenLoop> openLoop(const MissionState& state);

/// The operator's answer to @p loop: its scans are put together, or it is another place that looks alike, and
/// it is not asked about again.
[[nodiscard]] ScanLinksSample answerTo(const OpenLoop& loop, bool same, const std::string& station, Time now);

}  // namespace leitstand
