#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/robot/robot_description.h"
#include "core/robot/streams/stream_wish.h"

namespace leitstand {

/// What a stream costs while nobody wishes anything of it.
struct StreamCost {
    StreamRole role = StreamRole::Points;
    std::string topic;  ///< ROS name
    double rate = 0.0;  ///< [Hz]; 0: not known
    /// A second, onTheWire(); negative: not known, then what is usual of the role counts.
    double megabits = -1.0;
};

/// A robot on a link that shrinks.
struct ThinRobot {
    std::string name;
    bool thin = true;                 ///< whether its streams may be reduced; others only take their room
    bool selected = false;            ///< the operator looks at it: one camera of it survives
    std::vector<StreamCost> streams;  ///< in the order of its file
    std::string camera = {};          ///< topic of that camera; empty, or none of it: its first picture
};

/// How much there is to share, and how far things are reduced.
struct ThinSettings {
    double budget = 2.0;         ///< of all robots together [Mbit/s]
    double reserve = 0.2;        ///< for commands and what the wire itself needs [Mbit/s]
    double slowTelemetry = 5.0;  ///< odometry and the like, when nothing else helps [Hz]
};

/// What has to be asked of the streams of @p robots so that they fit the budget, by topic (plain wishes are
/// left out). The order in which things are kept (design, section 4): commands and stop, telemetry, scans,
/// one camera, the rest. So, until it fits:
/// 1. the rest (other cameras, infrared): once a second where there is room, else off;
/// 2. the camera of the selected robot that its driver looks through: slower, coarser, smaller (infrared:
///    slower alone), but never off;
/// 3. scans of robots that are not selected: off; those of the selected robot stay;
/// 4. inertial units, joints and transforms: slower. Odometry, modes, batteries, stops and answers to pings
///    are never touched.
[[nodiscard]] std::map<std::string, StreamWish> thinWishes(const std::vector<ThinRobot>& robots,
                                                           const ThinSettings& settings = {});

/// What a stream costs under @p wish [Mbit/s]: an estimate, coarser pictures are taken to shrink with their
/// quality and with their area.
[[nodiscard]] double costUnder(const StreamCost& stream, const StreamWish& wish);

/// What @p megabits of samples, @p rate [Hz] of them, take of the link with the headers of their datagrams
/// [Mbit/s].
[[nodiscard]] double onTheWire(double megabits, double rate);

/// What a stream of @p role usually costs [Mbit/s] and how often it comes [Hz].
[[nodiscard]] StreamCost usualCost(StreamRole role, const std::string& topic);

}  // namespace leitstand
