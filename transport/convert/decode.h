#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/event/event.h"
#include "core/event/raw_event.h"
#include "core/robot/robot_description.h"

namespace leitstand {

/// What a sample on @p stream of a robot says, checked from end to end: its bytes against its counts, its
/// fields and dimensions, its numbers. The error names topic, type and expectation. Frames stay as they were
/// sent; nothing big is allocated that the sample's own size does not justify.
[[nodiscard]] Result<Sample> decode(const RawEvent& event, const StreamDescription& stream);

/// The same as an event of @p robot, its frames named after its TfPrefix: "kurt3d/base_link". Transforms of
/// other robots on a shared topic are left out.
[[nodiscard]] Result<Event> decodeEvent(const RawEvent& event, const RobotDescription& robot,
                                        const StreamDescription& stream);

/// An event on one of the stations' own topics (station_topic); its type alone decides.
[[nodiscard]] Result<Event> decodeStationEvent(const RawEvent& event);

}  // namespace leitstand
