#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace leitstand::test {

/// A message of our IDL, filled as the peer fills it.
struct OurType {
    std::string rosName;                                    ///< "nav_msgs/msg/Odometry"
    std::string name;                                       ///< "nav_msgs/Odometry": what its topics end with
    std::vector<std::byte> (*encoded)(std::uint64_t seed);  ///< by our encoder, header included
};

/// All messages of the IDL; the code is made at build (generate_fill.py).
[[nodiscard]] const std::vector<OurType>& ourTypes();

}  // namespace leitstand::test
