#pragma once

#include <string_view>

#include "core/base/result.h"
#include "core/event/raw_event.h"
#include "core/event/sample.h"
#include "core/robot/robot_description.h"

namespace leitstand::detail {

/// Decodes @p event, a message of any type whose text is known, by the paths of @p stream.
[[nodiscard]] Result<Sample> decodeReading(const RawEvent& event, const StreamDescription& stream);

/// Encodes @p sample, whose values are usualReadings() of @p type.
[[nodiscard]] Result<Payload> encodeReading(const ReadingSample& sample, std::string_view type);

}  // namespace leitstand::detail
