#pragma once

#include <cstddef>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// All points of a key scan, those in the map and those that were removed from it. Each is stored once. Any
/// thread.
class KeptScan {
public:
    explicit KeptScan(ScanPtr scan) : m_inside(std::move(scan)) {}

    [[nodiscard]] ScanPtr whole() const;  ///< as received, in the same order; rebuilt if points were removed
    [[nodiscard]] ScanPtr inside() const;
    [[nodiscard]] std::size_t leftOut() const;  ///< number of removed points

    /// Removes all points except those at the indices @p kept (rising). inside() then has the kept points,
    /// unorganised. @p whole: result of whole().
    void leaveOutAllBut(const std::vector<std::size_t>& kept, const ScanPtr& whole);
    void putAllBack();

private:
    [[nodiscard]] ScanPtr joined() const;

    mutable std::mutex m_mutex;
    ScanPtr m_inside;
    Scan m_leftOut;
    std::vector<std::uint32_t> m_which;  ///< indices of the removed points in the whole scan, rising
    int m_rows = 0, m_columns = 0;       ///< size of the whole scan's grid, if points were removed
};

}  // namespace leitstand
