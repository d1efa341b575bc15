#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>

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

/// Returns what a sample says of another one; empty: nothing. A number that is not set is 0.
[[nodiscard]] inline std::optional<SampleIdentity> relatedOf(const fastdds::rtps::SampleIdentity& from) {
    if (from.writer_guid() == fastdds::rtps::GUID_t::unknown()) return std::nullopt;
    const bool numbered = from.sequence_number() != fastdds::rtps::SequenceNumber_t::unknown();
    return SampleIdentity{guidOf(from.writer_guid()), numbered ? numberOf(from.sequence_number()) : 0};
}
[[nodiscard]] inline fastdds::rtps::SampleIdentity fromIdentity(const SampleIdentity& from) {
    fastdds::rtps::GUID_t guid;
    for (std::size_t i = 0; i < 12; ++i) guid.guidPrefix.value[i] = from.endpoint.bytes[i];
    for (std::size_t i = 0; i < 4; ++i) guid.entityId.value[i] = from.endpoint.bytes[12 + i];
    fastdds::rtps::SampleIdentity to;
    to.writer_guid(guid);
    if (from.number != 0) {
        to.sequence_number(fastdds::rtps::SequenceNumber_t(static_cast<std::int32_t>(from.number >> 32U),
                                                           static_cast<std::uint32_t>(from.number)));
    }
    return to;
}

}  // namespace leitstand::detail
