#pragma once

#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/event/event.h"
#include "core/robot/robot_description.h"

namespace leitstand {

struct RawEvent;

/// Decodes @p event, a sample on a robot's @p stream, and checks everything: counts against bytes, fields,
/// dimensions, numbers. The error has topic, type and what was expected. Frames are left as they were sent.
/// Memory is allocated only in proportion to the sample's size.
[[nodiscard]] Result<Sample> decode(const RawEvent& event, const StreamDescription& stream);

/// Decodes as above, into an event of @p robot. Frames are renamed by frameName(), to names such as
/// "kurt3d/base_link". Leaves out transforms of other robots on a shared topic.
[[nodiscard]] Result<Event> decodeEvent(const RawEvent& event, const RobotDescription& robot,
                                        const StreamDescription& stream);

/// Decodes an event on one of the stations' own topics (station_topic). Only the type decides how.
[[nodiscard]] Result<Event> decodeStationEvent(const RawEvent& event);

}  // namespace leitstand
