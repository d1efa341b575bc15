#pragma once

#include <cstdint>
#include <optional>

#include "core/robot/link/link_status.h"
#include "widgets/models/live/texts/freshness.h"

namespace leitstand {

/// Measures the age of a stream of pictures: since the last arrival, and since the content last changed. The
/// second reveals a hanging driver that stamps one picture again and again.
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
