#pragma once

#include <cstdint>
#include <map>
#include <span>

#include "core/event/scan_links.h"

namespace leitstand {

/// Which key scans of a map hang together by links: what no active link leads to is a part of its own, and
/// nobody knows how it lies to the others.
class MapParts {
public:
    explicit MapParts(std::span<const Link> links);
    /// The lowest id of the scans that hang together with @p scan, itself included.
    [[nodiscard]] std::uint64_t lowest(std::uint64_t scan) const;

private:
    std::map<std::uint64_t, std::uint64_t> m_towards;  ///< from scan to a lower one of its part
};

}  // namespace leitstand
