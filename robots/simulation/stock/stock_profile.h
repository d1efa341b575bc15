#pragma once

#include <chrono>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/robot/robot_description.h"
#include "core/robot/streams/qos.h"

namespace leitstand::simulation {

/// A topic of a stock robot that carries nothing for the station, or nothing that the simulation has.
struct StockTopic {
    std::string_view topic;  ///< below the robot's namespace; with a slash first: absolute
    std::string_view type;
    Qos qos;
    double rate = 0.0;  ///< [Hz]; 0: once, at the start
};

/// A robot as its maker ships it. What it publishes and takes, of what the simulation has, stands in
/// resources/stock/NAME.yaml, with the sources; the rest here.
struct StockProfile {
    std::string_view name;                ///< "turtlebot4"
    std::string_view body;                ///< simulated robot whose body it has, "crawler"
    std::string_view nameSpace;           ///< that its topics have as shipped; empty: none
    std::chrono::nanoseconds watchdog{};  ///< after which it stops without commands
    std::span<const StockTopic> others;
};

[[nodiscard]] std::vector<std::string> stockProfiles();  ///< names
/// Null: there is none called @p name.
[[nodiscard]] const StockProfile* stockProfile(std::string_view name);

/// Returns what @p profile publishes and takes, in the namespace @p nameSpace instead of the shipped one.
/// Errors name the file.
[[nodiscard]] Result<RobotDescription> describe(const StockProfile& profile, const std::string& nameSpace);
/// Returns the topic @p name of a stock robot in @p nameSpace.
[[nodiscard]] std::string topicIn(const std::string& nameSpace, std::string_view name);

}  // namespace leitstand::simulation
