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

/// What the environment variables of ROS 2 say of the network, as rmw_fastrtps and rmw_dds_common read them
/// (docs.ros.org: "Configuring ROS 2 environment", "Improved Dynamic Discovery", "Setting access controls").
struct RosEnvironment {
    /// Whom ROS_AUTOMATIC_DISCOVERY_RANGE lets find each other.
    enum class Range : std::uint8_t { Subnet, Localhost, Off };

    std::optional<int> domain;                     ///< ROS_DOMAIN_ID, 0 to 232
    Range range = Range::Subnet;                   ///< Localhost also with ROS_LOCALHOST_ONLY=1
    bool localhostOnly = false;                    ///< ROS_LOCALHOST_ONLY=1; the peers are then empty
    std::vector<std::string> peers;                ///< ROS_STATIC_PEERS
    std::string discoveryServer;                   ///< ROS_DISCOVERY_SERVER
    std::filesystem::path keys;                    ///< folder of the enclave, if ROS_SECURITY_ENABLE is true
    bool enforced = false;                         ///< ROS_SECURITY_STRATEGY is Enforce
    std::map<std::string, std::string> variables;  ///< the variables above that are set: name -> value
};

/// Returns the value of a variable; null: it is not set.
using EnvironmentReader = std::function<const char*(const char* name)>;

/// Reads the environment through @p variable. Errors name the environment variable, what it holds, and what
/// was expected.
[[nodiscard]] Result<RosEnvironment> rosEnvironment(const EnvironmentReader& variable);
/// Reads the environment of this process. Removes ROS_DISCOVERY_SERVER from it, also for child processes:
/// Fast DDS would read it, too, whatever the options say. Call it before other threads begin.
[[nodiscard]] Result<RosEnvironment> rosEnvironment();

}  // namespace leitstand
