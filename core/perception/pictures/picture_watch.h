#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// Ages of what a camera shows.
struct PictureAges {
    double arrival = std::numeric_limits<double>::infinity();  ///< since a picture came [s]; infinite: never
    double content = std::numeric_limits<double>::infinity();  ///< since a picture came that differs from the
                                                               ///< one before [s]

    [[nodiscard]] double seconds() const { return arrival > content ? arrival : content; }
    /// Whether pictures still come, but the same one for more than @p limit seconds.
    [[nodiscard]] bool isFrozen(double limit) const { return content > limit && arrival <= limit; }
};

/// Measures the age of a camera's pictures by the gaps between their arrivals and by their content. This
/// detects a driver that hangs and stamps one picture again and again. Stamps are ignored. Pure.
class PictureWatch {
public:
    /// Call when a picture arrived. @p bytes: as they were sent, compressed or raw.
    void arrived(std::span<const std::byte> bytes, SteadyTime now);
    [[nodiscard]] PictureAges at(SteadyTime now) const;

private:
    std::optional<std::uint64_t> m_fingerprint;
    SteadyTime m_arrival = {}, m_change = {};
};

}  // namespace leitstand
