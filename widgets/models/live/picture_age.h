#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "core/robot/link_status.h"
#include "widgets/models/live/freshness.h"

namespace leitstand {

/// A number that differs between pictures that differ (FNV-1a over words); of the compressed or raw bytes.
[[nodiscard]] std::uint64_t contentHash(std::span<const std::byte> bytes);

/// Tells the age of a stream of pictures by their arrival and by their content: a driver that hangs and
/// stamps one picture again and again is found out.
class PictureAge {
public:
    /// A picture with @p content (contentHash()) arrived.
    void arrived(std::uint64_t content, SteadyTime now);
    [[nodiscard]] DataAge at(SteadyTime now) const;

private:
    std::optional<std::uint64_t> m_content;
    SteadyTime m_arrival = {}, m_change = {};
};

}  // namespace leitstand
