#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>

#include "core/robot/link/link_status.h"

namespace leitstand {

/// How old what a camera shows is.
struct PictureAges {
    double arrival = std::numeric_limits<double>::infinity();  ///< since a picture came [s]; infinite: never
    double content = std::numeric_limits<double>::infinity();  ///< since one came that differs [s]

    [[nodiscard]] double seconds() const { return arrival > content ? arrival : content; }
    /// Pictures come, but for @p limit seconds it was one and the same.
    [[nodiscard]] bool isFrozen(double limit) const { return content > limit && arrival <= limit; }
};

/// Tells the age of a camera's pictures by the gaps between their arrivals and by their content: a driver
/// that hangs and stamps one picture again and again is found out. Stamps are not looked at. Pure.
class PictureWatch {
public:
    /// A picture arrived; @p bytes as they were sent, compressed or raw.
    void arrived(std::span<const std::byte> bytes, SteadyTime now);
    [[nodiscard]] PictureAges at(SteadyTime now) const;

private:
    std::optional<std::uint64_t> m_fingerprint;
    SteadyTime m_arrival = {}, m_change = {};
};

}  // namespace leitstand
