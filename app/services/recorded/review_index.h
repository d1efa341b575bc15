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

/// Facts about a whole mission, which are read before any moment of it is shown. Immutable once shared.
struct ReviewIndex {
    /// Where a robot was according to its odometry.
    struct TrackPoint {
        Time received{}, stamp{};  ///< on the station's clock, and on the robot's
        Pose baseInOdom = Pose::Identity();
        std::chrono::nanoseconds notReceived{};  ///< longest gap in the odometry since the previous point
    };
    static constexpr double TrackApart = 0.1;         ///< distance between points of a track [m]
    std::vector<TimelineMark> marks;                  ///< by rising time
    std::vector<TimelineStretch> stretches;           ///< periods in which something was recorded
    std::map<std::uint64_t, KeyScanSample> keyScans;  ///< by id
    /// By robot; points are TrackApart or 10 degrees apart.
    std::map<std::string, std::vector<TrackPoint>> tracks;
    std::map<std::string, std::vector<RobotPlaceSample>> places;  ///< by robot, in the order received
    /// By robot: time received, and concentration [ppm].
    std::map<std::string, std::vector<std::pair<Time, double>>> gas;
    /// By robot and topic, for each reading: time received, and value. Where many came, some a second.
    std::map<std::pair<std::string, std::string>, std::vector<std::vector<std::pair<Time, double>>>> readings;
    std::vector<Event> fixed;  ///< events that never change: tf_static
    /// By robot: times at which its key scans were received.
    std::map<std::string, std::vector<Time>> scanned;
    Time lastReceived{};       ///< when a robot last sent something
    Time opensAt{};            ///< first moment that is worth showing
    MissionStatePtr finished;  ///< state at the end; never null
};
using ReviewIndexPtr = std::shared_ptr<const ReviewIndex>;

/// Reads all of @p log except its scans and pictures. When cancelled, returns what was read so far.
[[nodiscard]] ReviewIndexPtr indexOf(ReviewLog& log, const Progress& progress = {});

}  // namespace leitstand
