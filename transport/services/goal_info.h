#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "transport/cdr/cdr_reader.h"
#include "transport/cdr/cdr_writer.h"

namespace leitstand {

/// action_msgs/msg/GoalInfo: a goal of an action, and when it was accepted.
struct GoalInfo {
    static constexpr std::size_t LeastSize = 24;
    std::array<std::uint8_t, 16> id{};
    std::int32_t seconds = 0;
    std::uint32_t nanoseconds = 0;
};
inline void decode(CdrReader& in, GoalInfo& to) {
    in.read("goal_id", to.id);
    in.read("sec", to.seconds);
    in.read("nanosec", to.nanoseconds);
}
inline void encode(CdrWriter& out, const GoalInfo& from) {
    out.write(from.id);
    out.write(from.seconds);
    out.write(from.nanoseconds);
}

}  // namespace leitstand
