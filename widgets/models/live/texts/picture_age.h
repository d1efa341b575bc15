#pragma once

#include <cstdint>
#include <optional>

#include "core/robot/link/link_status.h"
#include "widgets/models/live/texts/freshness.h"

namespace leitstand {

/// Measures how old a stream of pictures is: since the last picture was received, and since the content last
/// changed. The second reveals a driver that hangs and sends one picture again and again with new stamps.
class PictureAge {
public:
    /// Call when a picture with @p content (contentHash()) is received.
    void arrived(std::uint64_t content, SteadyTime now);
    [[nodiscard]] DataAge at(SteadyTime now) const;

private:
    std::optional<std::uint64_t> m_content;
    SteadyTime m_arrival = {}, m_change = {};
};

}  // namespace leitstand
