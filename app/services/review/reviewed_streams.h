#pragma once

#include <vector>

#include "app/services/recorded/review_index.h"
#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct MissionState;

/// The last seconds before a moment of a mission, over which rates are computed.
struct RateWindow {
    Time from{}, to{};

    /// Returns the window before @p now, within one recorded period of @p index.
    [[nodiscard]] static RateWindow before(Time now, const ReviewIndex& index);
};

/// Returns how the streams of @p robot were received, in the order of its description. Rates are computed
/// from @p earlier, the state at the beginning of @p window, to @p state, that at its end. The whole mission
/// shows whether a stream is steady. A log has no losses, delays and shares of the link: these are NaN.
[[nodiscard]] std::vector<StreamStatus> reviewedStreams(const RobotDescription& robot,
                                                        const MissionState& earlier,
                                                        const MissionState& state, const RateWindow& window,
                                                        const ReviewIndex& index);

}  // namespace leitstand
