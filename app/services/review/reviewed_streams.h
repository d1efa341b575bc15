#pragma once

#include <vector>

#include "app/services/recorded/review_index.h"
#include "core/mission/state/mission_state.h"
#include "core/robot/link/link_status.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// The last seconds before a moment of a mission, in which rates are counted.
struct RateWindow {
    Time from{}, to{};

    /// Before @p now, in one stretch of what @p index knows to be recorded.
    [[nodiscard]] static RateWindow before(Time now, const ReviewIndex& index);
};

/// How what @p robot sends came in, in the order of its description: by what the log has of it in @p state at
/// the end of @p window and in @p earlier at its begin. What comes at a rate of its own is known by the whole
/// mission. No log tells what never arrived, how late, or what it took of the link: those are NaN.
[[nodiscard]] std::vector<StreamStatus> reviewedStreams(const RobotDescription& robot,
                                                        const MissionState& earlier,
                                                        const MissionState& state, const RateWindow& window,
                                                        const ReviewIndex& index);

}  // namespace leitstand
