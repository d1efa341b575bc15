#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/robot/robot_description.h"

namespace leitstand::detail {

// The words of robot files and their meanings.
template <class T>
using Words = std::vector<std::pair<std::string, T>>;

[[nodiscard]] const Words<StreamRole>& roleWords();
[[nodiscard]] const Words<Qos::Reliability>& reliabilityWords();
[[nodiscard]] const Words<Qos::Durability>& durabilityWords();
[[nodiscard]] const Words<StampSource>& stampWords();
[[nodiscard]] const Words<DriveType>& driveWords();
[[nodiscard]] const Words<SensorMotion>& motionWords();
[[nodiscard]] const Words<TfPrefix>& prefixWords();
[[nodiscard]] const Words<LinkLossRule>& linkLossWords();
[[nodiscard]] const Words<JointType>& jointTypeWords();
[[nodiscard]] const Words<JointCommandMode>& jointCommandWords();

/// Returns the word that stands for @p meaning in a robot's file.
template <class T>
[[nodiscard]] const std::string& wordFor(const Words<T>& words, T meaning) {
    for (const auto& [word, one] : words) {
        if (one == meaning) return word;
    }
    return words.front().first;
}

}  // namespace leitstand::detail
