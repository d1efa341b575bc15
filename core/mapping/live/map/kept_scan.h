#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// All points of a key scan, those that are in the map and those that are left out of it, each stored once.
/// Any thread.
class KeptScan {
public:
    explicit KeptScan(ScanPtr scan) : m_inside(std::move(scan)) {}

    [[nodiscard]] ScanPtr whole() const;  ///< as received, point for point; rebuilt if points are left out
    [[nodiscard]] ScanPtr inside() const;
    [[nodiscard]] std::size_t leftOut() const;  ///< number of points

    /// Leaves out all points except those at the indices @p kept, which rise; inside() has these,
    /// unorganised. @p whole: whole().
    void leaveOutAllBut(const std::vector<std::size_t>& kept, const ScanPtr& whole);
    void putAllBack();

private:
    [[nodiscard]] ScanPtr joined() const;

    mutable std::mutex m_mutex;
    ScanPtr m_inside;
    Scan m_leftOut;
    std::vector<std::uint32_t> m_which;  ///< places of the left-out points in the whole scan, rising
    int m_rows = 0, m_columns = 0;       ///< of the whole scan, where points are left out
};

}  // namespace leitstand
