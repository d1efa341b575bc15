#pragma once

#include <chrono>

#include "core/base/time.h"
#include "transport/dds/detail/fastdds.h"
#include "transport/dds/guid.h"

namespace leitstand::detail {

[[nodiscard]] inline Guid guidOf(const fastdds::rtps::GUID_t& guid) {
    Guid made;
    for (std::size_t i = 0; i < 12; ++i) made.bytes[i] = guid.guidPrefix.value[i];
    for (std::size_t i = 0; i < 4; ++i) made.bytes[12 + i] = guid.entityId.value[i];
    return made;
}

/// Returns 0 (the epoch) when @p time is not set.
[[nodiscard]] inline Time timeOf(const fastdds::rtps::Time_t& time) {
    if (time.seconds() <= 0) return {};
    return Time{std::chrono::nanoseconds{time.to_ns()}};
}

[[nodiscard]] inline std::uint64_t numberOf(const fastdds::rtps::SequenceNumber_t& number) {
    return number.to64long();
}

}  // namespace leitstand::detail
