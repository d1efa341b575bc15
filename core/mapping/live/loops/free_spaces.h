#pragma once

#include <cstddef>
#include <cstdint>
#include <map>

#include "core/cloud/scan.h"
#include "core/mapping/live/loops/free_space.h"

namespace leitstand {

/// What scans looked through, made once for each, of those that were asked for last: a scan's takes 0.2 MB.
class FreeSpaces {
public:
    explicit FreeSpaces(const FreeSpaceSettings& settings, std::size_t most = 128)
        : m_settings(settings), m_most(most) {}

    /// Of @p scan, which is the key scan @p id whenever that is asked for; valid until the next call.
    [[nodiscard]] const FreeSpace& of(std::uint64_t id, const Scan& scan);

private:
    struct Made {
        FreeSpace free;
        std::uint64_t used = 0;  ///< the number of the call that asked for it last
    };
    FreeSpaceSettings m_settings;
    std::size_t m_most;
    std::map<std::uint64_t, Made> m_made;
    std::uint64_t m_calls = 0;
};

}  // namespace leitstand
