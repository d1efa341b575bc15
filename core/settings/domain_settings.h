#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

struct RosEnvironment;

/// What the user states about the network by options or configuration. RosEnvironment decides what the user
/// leaves open.
struct DomainOptions {
    std::optional<int> domain = {};              ///< 0 to 232
    std::vector<std::string> interfaces = {};    ///< names or addresses
    std::vector<std::string> initialPeers = {};  ///< addresses of robots where multicast does not pass
    std::string discoveryServer = {};            ///< as in ROS_DISCOVERY_SERVER
    std::filesystem::path keys = {};             ///< folder of an identity, "KEYS/enclaves/station1"
};

/// How a program joins a domain.
struct DomainSettings {
    int domain = 0;                              ///< 0 to 232
    std::vector<std::string> interfaces = {};    ///< names or addresses; empty: all
    std::vector<std::string> initialPeers = {};  ///< contacted by unicast where multicast does not pass
    bool multicast = true;                       ///< false: only initialPeers are contacted
    std::string discoveryServer = {};            ///< as in ROS_DISCOVERY_SERVER; empty: peers find each other
    std::filesystem::path keys = {};             ///< folder of an identity; empty: open
    bool openWithoutKeys = false;                ///< join without security when the folder of keys is missing
    /// Environment variables of ROS that decided some of these settings: "ROS_DOMAIN_ID=7".
    std::vector<std::string> fromEnvironment = {};
};

/// Returns how a program joins the domain, by the user's @p options and by @p environment. If any option says
/// whom to find (interfaces, peers, server), all variables that say so are ignored. Error when a variable
/// keeps the program from finding anybody; it names the variable.
[[nodiscard]] Result<DomainSettings> domainSettings(const DomainOptions& options,
                                                    const RosEnvironment& environment);
/// Returns a line for the user on what the variables of ROS decided; empty: nothing.
[[nodiscard]] std::string environmentLine(const DomainSettings& settings);

}  // namespace leitstand
