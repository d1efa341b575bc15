#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"
#include "core/robot/streams/stream_request.h"

namespace leitstand {

/// Cost of a stream when nothing is requested.
struct StreamCost {
    StreamRole role{};
    std::string topic;  ///< ROS name
    double rate = 0.0;  ///< [Hz]; 0: unknown
    /// load as computed by onTheWire() [Mbit/s]; negative: unknown, the usual load of the role is assumed
    double megabits = -1.0;
};

/// A robot on a link whose capacity may be too small.
struct ThinRobot {
    std::string name;
    bool thin = true;                 ///< whether its streams may be reduced; if not, they only use capacity
    bool selected = false;            ///< whether the operator has selected it: one of its cameras stays on
    std::vector<StreamCost> streams;  ///< in the order of its file
    std::string camera = {};  ///< topic of the camera that stays on; empty or unknown: the first picture
};

/// The capacity that streams share, and how far they are reduced.
struct ThinSettings {
    double budget = 2.0;   ///< capacity for all robots together [Mbit/s]
    double reserve = 0.2;  ///< capacity kept for commands and the overhead of packets [Mbit/s]
    /// Reduced rate of inertial units, joints and transforms [Hz], used as the last resort.
    double slowTelemetry = 5.0;
};

/// Returns the requests, by topic, with which the streams of @p robots fit the budget. Streams without a
/// restriction are left out. The order of priority is (docs/design.md, "The wire"): commands and stop,
/// telemetry, scans, one camera, the rest. So these steps are taken in turn until the budget is kept:
/// 1. the rest (other cameras, infrared): once a second if there is room, otherwise off;
/// 2. the camera of the selected robot that its driver looks through: slower, coarser, smaller (infrared:
///    slower only), but never off;
/// 3. scans of robots that are not selected: off; those of the selected robot: slower, but never off;
/// 4. inertial units, joints and transforms: slower. Odometry, modes, batteries, stops and answers to pings
///    are never reduced.
[[nodiscard]] std::map<std::string, StreamRequest> thinRequests(const std::vector<ThinRobot>& robots,
                                                                const ThinSettings& settings = {});

/// Estimates the cost of a stream under @p request [Mbit/s]. Assumes that the size of pictures is
/// proportional to their quality and area.
[[nodiscard]] double costUnder(const StreamCost& stream, const StreamRequest& request);

/// Returns the load on the link [Mbit/s] of samples of @p megabits [Mbit/s] at @p rate [Hz], including the
/// headers of their packets.
[[nodiscard]] double onTheWire(double megabits, double rate);

/// Returns the usual cost [Mbit/s] and rate [Hz] of a stream of @p role.
[[nodiscard]] StreamCost usualCost(StreamRole role, const std::string& topic);

}  // namespace leitstand
