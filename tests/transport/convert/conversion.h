#pragma once

#include <bit>
#include <string_view>

#include "core/event/raw_event.h"
#include "core/event/sample.h"
#include "tests/support/samples.h"
#include "transport/convert/decode.h"
#include "transport/convert/encode.h"

namespace leitstand::test {

/// @p bytes of a sample as they would reach the station.
[[nodiscard]] RawEvent rawEvent(const SampleCase& one, std::vector<std::byte> bytes);

/// What the station makes of @p event, by the stream of @p one or as a station's own.
[[nodiscard]] Result<Sample> decodeCase(const SampleCase& one, const RawEvent& event);

/// The sample's message; a failure of the test when there is none.
[[nodiscard]] std::vector<std::byte> encoded(const SampleCase& one);

/// A message of the ROS type @p type read and written again in another byte order; an error when it cannot be
/// read. For all types of the catalog.
[[nodiscard]] Result<std::vector<std::byte>> recoded(std::string_view type, std::span<const std::byte> bytes,
                                                     std::endian order);

}  // namespace leitstand::test
