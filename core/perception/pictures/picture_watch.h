#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// How old the pictures of a camera are.
struct PictureAges {
    /// Since the last picture arrived [s]; infinite: never.
    double arrival = std::numeric_limits<double>::infinity();
    /// Since the last picture arrived that differs from the one before [s].
    double content = std::numeric_limits<double>::infinity();

    [[nodiscard]] double seconds() const { return arrival > content ? arrival : content; }
    /// Whether pictures still arrive, but have been the same for more than @p limit seconds.
    [[nodiscard]] bool isFrozen(double limit) const { return content > limit && arrival <= limit; }
};

/// Measures how old a camera's pictures are: when they arrived, and when their content changed. This detects
/// a driver that hangs and sends one picture again and again with new stamps. Stamps are ignored. Pure.
class PictureWatch {
public:
    /// Call when a picture arrives. @p bytes: as they were sent, compressed or raw.
    void arrived(std::span<const std::byte> bytes, SteadyTime now);
    [[nodiscard]] PictureAges at(SteadyTime now) const;

private:
    std::optional<std::uint64_t> m_fingerprint;
    SteadyTime m_arrival = {}, m_change = {};
};

}  // namespace leitstand
