#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace leitstand {

struct NodeSettings;

/// How a program joins a domain, as its user configures it.
struct DomainSettings {
    int domain = 0;                              ///< 0 to 232
    std::vector<std::string> interfaces = {};    ///< names or addresses; empty: all
    std::vector<std::string> initialPeers = {};  ///< contacted by unicast where multicast does not pass
    std::string discoveryServer = {};            ///< as in ROS_DISCOVERY_SERVER; empty: peers find each other
    std::filesystem::path keys = {};  ///< folder of an identity, "KEYS/enclaves/station1"; empty: open
};

/// Converts @p settings to those of the network node, for a participant called @p name. Errors name the file
/// that makes the identity unusable.
[[nodiscard]] Result<NodeSettings> nodeSettings(const DomainSettings& settings, const std::string& name);

/// Returns a line for the operator on whether the domain is secured.
[[nodiscard]] std::string securityLine(const DomainSettings& settings);

}  // namespace leitstand
