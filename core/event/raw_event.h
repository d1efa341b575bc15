#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/time.h"

namespace leitstand {

/// Serialised bytes as received: XCDR1 with its encapsulation header of 4 bytes.
using Payload = std::shared_ptr<const std::vector<std::byte>>;

/// A message as the station received it: one entry of the mission's log (docs/design.md, "A mission is its
/// log").
struct RawEvent {
    std::uint64_t sequence = 0;  ///< order of arrival within a mission, from 1; 0: not assigned yet
    Time received{};             ///< station's clock
    std::string topic;           ///< ROS name with its slash: "/kurt3d/odom"
    std::string type;            ///< ROS name: "nav_msgs/msg/Odometry"
    Payload cdr;                 ///< never null after it was received
};

}  // namespace leitstand
