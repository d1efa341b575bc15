#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// State of a robot's guard: the process that sends zeros to the robot when its station hangs or dies.
struct GuardView {
    enum class State : std::uint8_t {
        None,      ///< the robot needs no guard, or is not driven
        Starting,  ///< the robot does not hear it yet; do not drive the robot
        Ready,     ///< the robot hears the guard's commands
        Failed,    ///< it does not work; do not drive the robot
    };
    State state = State::None;
    std::string problem = {};  ///< what is wrong (Failed), English text
    friend bool operator==(const GuardView&, const GuardView&) = default;
};

}  // namespace leitstand
