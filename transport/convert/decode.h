#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/event/event.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct RawEvent;

/// Decodes a sample on @p stream of a robot and checks it from end to end: its bytes against its counts, its
/// fields and dimensions, its numbers. The error names topic, type and expectation. Frames stay as they were
/// sent. Allocates nothing big that the sample's own size does not justify.
[[nodiscard]] Result<Sample> decode(const RawEvent& event, const StreamDescription& stream);

/// Decodes as above into an event of @p robot, with frames named after its TfPrefix: "kurt3d/base_link".
/// Leaves out transforms of other robots on a shared topic.
[[nodiscard]] Result<Event> decodeEvent(const RawEvent& event, const RobotDescription& robot,
                                        const StreamDescription& stream);

/// Decodes an event on one of the stations' own topics (station_topic). The type alone selects the decoder.
[[nodiscard]] Result<Event> decodeStationEvent(const RawEvent& event);

}  // namespace leitstand
