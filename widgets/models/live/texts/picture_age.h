#pragma once

#include <cstdint>
#include <optional>

#include "core/robot/link/link_status.h"
#include "widgets/models/live/texts/freshness.h"

namespace leitstand {

/// The age of a stream of pictures by their arrival and by their content. It detects a driver that hangs and
/// stamps one picture again and again.
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
