#pragma once

#include <optional>
#include <string>
#include <vector>

namespace leitstand {

/// Settings with which the station was last opened on live robots. It opens with them again next time.
struct LastStation {
    std::vector<std::string> robots = {};        ///< files, or names of shipped ones
    std::optional<int> domain = {};              ///< DDS domain, if one was chosen
    std::vector<std::string> interfaces = {};    ///< network cards; empty: all
    std::vector<std::string> initialPeers = {};  ///< where multicast does not pass
    std::string discoveryServer = {};            ///< as in ROS_DISCOVERY_SERVER; empty: none
    std::string keys = {};                       ///< folder of an identity; empty: no security
    friend bool operator==(const LastStation&, const LastStation&) = default;
};

}  // namespace leitstand
