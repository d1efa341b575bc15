#pragma once

#include <vector>

#include "app/services/recorded/review_index.h"
#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct MissionState;

/// The last seconds before a moment of a mission, in which rates are counted.
struct RateWindow {
    Time from{}, to{};

    /// Returns the window before @p now, within one recorded stretch of @p index.
    [[nodiscard]] static RateWindow before(Time now, const ReviewIndex& index);
};

/// Returns how the streams of @p robot came in, in the order of its description. Rates are counted from @p
/// earlier, the state at the begin of @p window, to @p state, that at its end. Whether a stream is steady is
/// judged by the whole mission. A log does not hold losses, delays and shares of the link: those are NaN.
[[nodiscard]] std::vector<StreamStatus> reviewedStreams(const RobotDescription& robot,
                                                        const MissionState& earlier,
                                                        const MissionState& state, const RateWindow& window,
                                                        const ReviewIndex& index);

}  // namespace leitstand
