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
#include "core/event/map_samples.h"
#include "core/mission/state/mission_state.h"
#include "core/mission/timeline/timeline_marks.h"

namespace leitstand {

class ReviewLog;

/// Facts about a whole mission, read before any of its moments is shown. Immutable once shared.
struct ReviewIndex {
    /// Where a robot was by its odometry.
    struct TrackPoint {
        Time received{}, stamp{};  ///< station's and robot's clock
        Pose baseInOdom = Pose::Identity();
        std::chrono::nanoseconds notReceived{};  ///< longest gap in the odometry since the point before
    };
    static constexpr double TrackApart = 0.1;               ///< between two points of a track [m]
    std::vector<TimelineMark> marks;                        ///< by time
    std::vector<TimelineStretch> stretches;                 ///< in which something was recorded
    std::map<std::uint64_t, KeyScanSample> keyScans;        ///< by id
    std::map<std::string, std::vector<TrackPoint>> tracks;  ///< by robot, TrackApart or 10 degrees apart
    std::map<std::string, std::vector<RobotPlaceSample>> places;      ///< by robot, as they came
    std::map<std::string, std::vector<std::pair<Time, double>>> gas;  ///< by robot: when received, [ppm]
    std::vector<Event> fixed;                                         ///< events that never change: tf_static
    std::map<std::string, std::vector<Time>> scanned;  ///< by robot: when its key scans were received
    Time lastReceived{};                               ///< when a robot sent something last
    Time opensAt{};                                    ///< the first moment worth looking at
    MissionStatePtr finished;                          ///< the state at the end; never null
};
using ReviewIndexPtr = std::shared_ptr<const ReviewIndex>;

/// Reads all of @p log except its scans and pictures. When cancelled, returns what was read so far.
[[nodiscard]] ReviewIndexPtr indexOf(ReviewLog& log, const Progress& progress = {});

}  // namespace leitstand
