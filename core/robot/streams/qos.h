#pragma once

#include <cstdint>
#include <string>

namespace leitstand {

/// The parts of a DDS quality of service in which ROS 2 robots differ.
struct Qos {
    enum class Reliability : std::uint8_t { BestEffort, Reliable };
    enum class Durability : std::uint8_t { Volatile, TransientLocal };
    Reliability reliability = Reliability::Reliable;
    Durability durability = Durability::Volatile;
    int depth = 1;          ///< number of samples (keep_last); 0: keep_all
    double lifespan = 0.0;  ///< lifespan [s]; 0: for ever
    double deadline = 0.0;  ///< deadline [s]; 0: none; requested only if the robot's file has one
    friend bool operator==(const Qos&, const Qos&) = default;
};

}  // namespace leitstand
