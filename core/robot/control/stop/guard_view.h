#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// State of a robot's guard: the process that sends it zeros when its station hangs or dies.
struct GuardView {
    enum class State : std::uint8_t {
        None,      ///< the robot needs none, or is not driven
        Starting,  ///< not yet heard by the robot, which is not driven before
        Ready,     ///< the robot hears its commands
        Failed,    ///< the robot is not driven
    };
    State state = State::None;
    std::string problem = {};  ///< for Failed, in words
    friend bool operator==(const GuardView&, const GuardView&) = default;
};

}  // namespace leitstand
