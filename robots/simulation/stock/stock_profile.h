#pragma once

#include <chrono>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"
#include "core/robot/streams/qos.h"
#include "robots/simulation/sensors/laser/spinning_lidar.h"

namespace leitstand::simulation {

/// A topic of a stock robot without content for the station, or without content in the simulation.
struct StockTopic {
    std::string_view topic;  ///< name below the robot's namespace; absolute if it begins with a slash
    std::string_view type;
    Qos qos;
    double rate = 0.0;  ///< rate [Hz]; 0: once, at the start
};

/// A robot as its manufacturer delivers it. The simulated topics that it publishes and takes are in
/// resources/stock/NAME.yaml, with sources; everything else is here.
struct StockProfile {
    std::string_view name;                     ///< "turtlebot4"
    std::string_view body;                     ///< simulated robot whose body is used, "crawler"
    std::string_view nameSpace;                ///< namespace of its topics as delivered; empty: none
    std::chrono::nanoseconds watchdog{};       ///< it stops after this time without commands
    SpinningLidarSettings (*lidar)() = vlp16;  ///< its 3D scanner, if it has one
    bool mountTold = true;                     ///< whether tf tells where the 3D scanner sits
    double gravity = 1.0;                      ///< unit of accelerations that it reports [m/s2]
    std::span<const StockTopic> others;
};

[[nodiscard]] std::vector<std::string> stockProfiles();  ///< names of all profiles
/// Null: there is no profile called @p name.
[[nodiscard]] const StockProfile* stockProfile(std::string_view name);

/// Returns what @p profile publishes and takes, in the namespace @p nameSpace instead of that of the profile.
/// Errors name the file.
[[nodiscard]] Result<RobotDescription> describe(const StockProfile& profile, const std::string& nameSpace);
/// Returns the topic @p name of a stock robot in @p nameSpace.
[[nodiscard]] std::string topicIn(const std::string& nameSpace, std::string_view name);

}  // namespace leitstand::simulation
