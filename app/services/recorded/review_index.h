#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/base/pose.h"
#include "core/base/progress.h"
#include "core/event/event.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/timeline/timeline_marks.h"

namespace leitstand {

class ReviewLog;

/// What is known of a whole mission before a moment of it is looked at. Immutable once shared.
struct ReviewIndex {
    /// Where a robot was by its odometry.
    struct TrackPoint {
        Time received{}, stamp{};  ///< station's and robot's clock
        Pose baseInOdom = Pose::Identity();
        std::chrono::nanoseconds unheard{};  ///< longest silence of the odometry since the point before
    };
    static constexpr double TrackApart = 0.1;               ///< of its points [m]
    std::vector<TimelineMark> marks;                        ///< by time
    std::vector<TimelineStretch> stretches;                 ///< in which something was recorded
    std::map<std::uint64_t, KeyScanSample> keyScans;        ///< by id
    std::map<std::string, std::vector<TrackPoint>> tracks;  ///< by robot, TrackApart or 10 degrees apart
    std::map<std::string, std::vector<RobotPlaceSample>> places;      ///< by robot, as they came
    std::map<std::string, std::vector<std::pair<Time, double>>> gas;  ///< by robot: when received, [ppm]
    std::vector<Event> fixed;                                         ///< of what never changes: tf_static
    std::map<std::string, std::vector<Time>> scanned;  ///< by robot: when its key scans were received
    Time lastHeard{};                                  ///< when a robot said something last
    Time opensAt{};                                    ///< the first moment that is worth to be looked at
    MissionStatePtr finished;                          ///< the state at the end; never null
};
using ReviewIndexPtr = std::shared_ptr<const ReviewIndex>;

/// Reads through all of @p log but its scans and pictures. Cancelled: as far as it came.
[[nodiscard]] ReviewIndexPtr indexOf(ReviewLog& log, const Progress& progress = {});

}  // namespace leitstand
