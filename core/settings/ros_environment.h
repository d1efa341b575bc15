#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

/// What the environment variables of ROS 2 say about the network, read as rmw_fastrtps and rmw_dds_common do.
/// See docs.ros.org: "Configuring ROS 2 environment", "Improved Dynamic Discovery", "Setting access
/// controls".
struct RosEnvironment {
    /// Which computers find each other, from ROS_AUTOMATIC_DISCOVERY_RANGE.
    enum class Range : std::uint8_t { Subnet, Localhost, Off };

    std::optional<int> domain;       ///< ROS_DOMAIN_ID, 0 to 232
    Range range = Range::Subnet;     ///< also Localhost when ROS_LOCALHOST_ONLY=1
    bool localhostOnly = false;      ///< whether ROS_LOCALHOST_ONLY=1; then there are no peers
    std::vector<std::string> peers;  ///< ROS_STATIC_PEERS
    std::string discoveryServer;     ///< ROS_DISCOVERY_SERVER
    std::filesystem::path keys;      ///< folder of the enclave, if ROS_SECURITY_ENABLE is true
    bool enforced = false;           ///< whether ROS_SECURITY_STRATEGY is Enforce
    /// Those of the variables above that are set: name -> value.
    std::map<std::string, std::string> variables;
};

/// Returns the value of a variable; null: it is not set.
using EnvironmentReader = std::function<const char*(const char* name)>;

/// Reads the environment through @p variable. Errors name the environment variable, its value and what was
/// expected.
[[nodiscard]] Result<RosEnvironment> rosEnvironment(const EnvironmentReader& variable);
/// Reads the environment of this process. Removes ROS_DISCOVERY_SERVER from it, also for child processes,
/// because Fast DDS would read it regardless of the options. Call it before other threads begin.
[[nodiscard]] Result<RosEnvironment> rosEnvironment();

}  // namespace leitstand
