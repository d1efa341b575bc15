#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace leitstand::detail {

/// Numbers the occupied cubes of a grid 0, 1, 2 ..., in the order in which cellOf() first meets them. It is a
/// hash table with linear probing over 64-bit keys (21 bits per axis).
class CellTable {
public:
    static constexpr std::uint32_t Outside = 0xffffffff;

    /// A grid of cubes with edges of @p edge [m] and a corner at @p origin. It first has room for @p expected
    /// cubes, and grows.
    explicit CellTable(double edge, std::size_t expected = 0,
                       const Eigen::Vector3d& origin = Eigen::Vector3d::Zero())
        : m_perMetre(1.0 / edge),
          m_from(Eigen::Vector3d::Constant(Half) - origin * m_perMetre),
          m_slots(std::max(InitialSlots, std::bit_ceil(2 * expected))),
          m_shift(64 - std::countr_zero(m_slots.size())) {}

    /// Returns the number of the cube that contains @p point [m]. Returns Outside for points that are not
    /// finite, or farther than 2^20 edges from the origin along an axis.
    [[nodiscard]] std::uint32_t cellOf(const Eigen::Vector3f& point) {
        const double x = point.x() * m_perMetre + m_from.x(), y = point.y() * m_perMetre + m_from.y(),
                     z = point.z() * m_perMetre + m_from.z();
        if (!(x >= 0.0 && x < 2 * Half && y >= 0.0 && y < 2 * Half && z >= 0.0 && z < 2 * Half)) {
            return Outside;
        }
        // All are positive here: truncation rounds down.
        const std::uint64_t key = static_cast<std::uint64_t>(static_cast<std::int64_t>(x)) << 42 |
                                  static_cast<std::uint64_t>(static_cast<std::int64_t>(y)) << 21 |
                                  static_cast<std::uint64_t>(static_cast<std::int64_t>(z));
        if (key != m_lastKey) {
            m_lastKey = key;
            m_lastCell = find(key);
        }
        return m_lastCell;
    }

    /// Number of cubes met so far.
    [[nodiscard]] std::size_t size() const { return m_count; }

private:
    static constexpr double Half = 1 << 20;
    static constexpr std::uint64_t NoKey = ~std::uint64_t{0};
    static constexpr std::size_t InitialSlots = 1 << 12;

    struct Slot {
        std::uint64_t key = NoKey;
        std::uint32_t cell = 0;
    };

    [[nodiscard]] std::size_t slotOf(std::uint64_t key) const {
        // The multiplication spreads all bits into the upper ones (Knuth's Fibonacci hashing).
        std::size_t slot = (key * 0x9e3779b97f4a7c15U) >> m_shift;
        while (m_slots[slot].key != key && m_slots[slot].key != NoKey)
            slot = (slot + 1) & (m_slots.size() - 1);
        return slot;
    }
    [[nodiscard]] std::uint32_t find(std::uint64_t key) {
        Slot& slot = m_slots[slotOf(key)];
        if (slot.key == key) return slot.cell;
        const std::uint32_t cell = m_count++;
        slot = {key, cell};
        if (2 * std::size_t{m_count} > m_slots.size()) grow();
        return cell;
    }
    void grow() {
        std::vector<Slot> old(m_slots.size() * 4);
        old.swap(m_slots);
        m_shift -= 2;
        for (const Slot& slot : old) {
            if (slot.key != NoKey) m_slots[slotOf(slot.key)] = slot;
        }
    }

    double m_perMetre;
    Eigen::Vector3d m_from;  ///< added to scaled coordinates [edges]
    std::vector<Slot> m_slots;
    int m_shift;
    std::uint32_t m_count = 0;
    std::uint64_t m_lastKey = NoKey;  ///< key of the last point: neighbours in a scan often share a cube
    std::uint32_t m_lastCell = Outside;
};

}  // namespace leitstand::detail
