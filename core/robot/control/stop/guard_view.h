#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// State of a robot's guard: the process that sends it zeros when its station hangs or dies.
struct GuardView {
    enum class State : std::uint8_t {
        None,      ///< the robot needs no guard, or is not driven
        Starting,  ///< the robot does not hear it yet, and must not be driven until then
        Ready,     ///< the robot hears the guard's commands
        Failed,    ///< it does not work: the robot must not be driven
    };
    State state = State::None;
    std::string problem = {};  ///< for Failed, in words
    friend bool operator==(const GuardView&, const GuardView&) = default;
};

}  // namespace leitstand
