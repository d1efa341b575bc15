#pragma once

#include <string>
#include <vector>

namespace leitstand {

/// Settings with which the station on live robots was last opened; it opens with them again.
struct LastStation {
    std::vector<std::string> robots = {};      ///< files, or names of shipped ones
    int domain = 0;                            ///< DDS domain
    std::vector<std::string> interfaces = {};  ///< network cards; empty: all
    std::string keys = {};                     ///< folder of an identity; empty: no security
    friend bool operator==(const LastStation&, const LastStation&) = default;
};

}  // namespace leitstand
