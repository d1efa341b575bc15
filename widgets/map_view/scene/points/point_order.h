#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace leitstand {

/// Which points of a list are drawn, in their order: their places in it, in two bytes each where all are
/// below 65536, which those of a scan mostly are, else in four. Immutable.
class PointOrder {
public:
    PointOrder() = default;
    explicit PointOrder(const std::vector<std::uint32_t>& places);

    [[nodiscard]] std::size_t size() const { return m_narrow.size() + m_wide.size(); }
    [[nodiscard]] bool empty() const { return size() == 0; }
    [[nodiscard]] std::size_t operator[](std::size_t i) const {
        return m_wide.empty() ? m_narrow[i] : m_wide[i];
    }
    /// The places as they lie in memory; one of the two is empty.
    [[nodiscard]] const std::vector<std::uint16_t>& narrow() const { return m_narrow; }
    [[nodiscard]] const std::vector<std::uint32_t>& wide() const { return m_wide; }
    /// Bytes that it takes.
    [[nodiscard]] std::size_t memory() const;

private:
    std::vector<std::uint16_t> m_narrow;
    std::vector<std::uint32_t> m_wide;
};

}  // namespace leitstand
