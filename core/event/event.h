#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/base/time.h"
#include "core/event/sample.h"

namespace leitstand {

enum class StreamRole : std::uint8_t;

/// A decoded RawEvent, from which core computes the state of the mission (docs/design.md, "A mission is its
/// log").
struct Event {
    std::uint64_t sequence = 0;      ///< order of arrival within the mission, from 1
    Time received{};                 ///< station's clock
    std::string robot;               ///< "kurt3d"; empty for the station's own topics
    std::string topic;               ///< ROS name, "/kurt3d/odom", "/leitstand/victims"
    std::optional<StreamRole> role;  ///< what the topic contains; empty for the station's own topics
    std::string sensor;              ///< StreamDescription::sensor
    Sample sample;
};

}  // namespace leitstand
