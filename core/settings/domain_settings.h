#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

struct RosEnvironment;

/// What the user specified about the network, in options or in a configuration. RosEnvironment decides what
/// the user left open.
struct DomainOptions {
    std::optional<int> domain = {};            ///< 0 to 232
    std::vector<std::string> interfaces = {};  ///< names or addresses
    /// Addresses of robots, for networks that do not forward multicast.
    std::vector<std::string> initialPeers = {};
    std::string discoveryServer = {};  ///< as in the variable ROS_DISCOVERY_SERVER
    std::filesystem::path keys = {};   ///< folder with the keys of an identity, "KEYS/enclaves/station1"
};

/// How a program joins a domain.
struct DomainSettings {
    int domain = 0;                            ///< 0 to 232
    std::vector<std::string> interfaces = {};  ///< names or addresses; empty: all
    /// Addresses for unicast, for networks that do not forward multicast.
    std::vector<std::string> initialPeers = {};
    bool multicast = true;  ///< false: only initialPeers are contacted
    /// As in the variable ROS_DISCOVERY_SERVER; empty: peers find each other.
    std::string discoveryServer = {};
    std::filesystem::path keys = {};  ///< folder with the keys of an identity; empty: no security
    bool openWithoutKeys = false;     ///< whether to join without security when the folder of keys is missing
    /// Environment variables of ROS that decided some of these settings: "ROS_DOMAIN_ID=7".
    std::vector<std::string> fromEnvironment = {};
};

/// Returns how a program joins the domain, according to the user's @p options and to @p environment. If any
/// option says whom to look for (interfaces, peers, server), all variables about this are ignored. Error when
/// a variable prevents the program from finding anybody; it names the variable.
[[nodiscard]] Result<DomainSettings> domainSettings(const DomainOptions& options,
                                                    const RosEnvironment& environment);
/// Returns a line for the user about what the variables of ROS decided; empty: nothing.
[[nodiscard]] std::string environmentLine(const DomainSettings& settings);

}  // namespace leitstand
