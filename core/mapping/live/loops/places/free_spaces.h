#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "core/cloud/scan.h"
#include "core/mapping/live/loops/places/free_space.h"

namespace leitstand {

/// Computes the free space of each scan once, and keeps the results for the scans used last: 0.2 MB per scan.
class FreeSpaces {
public:
    explicit FreeSpaces(const FreeSpaceSettings& settings, std::size_t most = 128)
        : m_settings(settings), m_most(most) {}

    /// Returns the free space of @p scan, valid until the next call. @p id: id of the scan, under which the
    /// result is kept.
    [[nodiscard]] const FreeSpace& of(std::uint64_t id, const Scan& scan);

private:
    struct Made {
        FreeSpace free;
        std::uint64_t used = 0;  ///< number of the last call that used it
    };
    FreeSpaceSettings m_settings;
    std::size_t m_most;
    std::map<std::uint64_t, Made> m_made;
    std::uint64_t m_calls = 0;
};

}  // namespace leitstand
