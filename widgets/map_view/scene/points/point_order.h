#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace leitstand {

/// The drawing order of points, as indices into their list. Each index takes two bytes if all are below
/// 65536, as for most scans, otherwise four. Immutable.
class PointOrder {
public:
    PointOrder() = default;
    explicit PointOrder(const std::vector<std::uint32_t>& places);

    [[nodiscard]] std::size_t size() const { return m_narrow.size() + m_wide.size(); }
    [[nodiscard]] bool empty() const { return size() == 0; }
    [[nodiscard]] std::size_t operator[](std::size_t i) const {
        return m_wide.empty() ? m_narrow[i] : m_wide[i];
    }
    /// The indices as stored. One of narrow() and the other vector is empty.
    [[nodiscard]] const std::vector<std::uint16_t>& narrow() const { return m_narrow; }
    [[nodiscard]] const std::vector<std::uint32_t>& wide() const { return m_wide; }
    /// Returns how much memory it uses [B].
    [[nodiscard]] std::size_t memory() const;

private:
    std::vector<std::uint16_t> m_narrow;
    std::vector<std::uint32_t> m_wide;
};

}  // namespace leitstand
