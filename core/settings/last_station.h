#pragma once

#include <optional>
#include <string>
#include <vector>

namespace leitstand {

/// Settings with which the station was last opened on live robots. They are used when it is opened again.
struct LastStation {
    std::vector<std::string> robots = {};        ///< files, or names of shipped ones
    std::optional<int> domain = {};              ///< DDS domain, if one was chosen
    std::vector<std::string> interfaces = {};    ///< network cards; empty: all
    std::vector<std::string> initialPeers = {};  ///< addresses, for networks that do not forward multicast
    std::string discoveryServer = {};            ///< as in the variable ROS_DISCOVERY_SERVER; empty: none
    std::string keys = {};                       ///< folder with the keys of an identity; empty: no security
    friend bool operator==(const LastStation&, const LastStation&) = default;
};

}  // namespace leitstand
