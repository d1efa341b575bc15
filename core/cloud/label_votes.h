#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/cloud/scan.h"

namespace leitstand {

/// Counts the labels of several points that are merged into one.
class LabelVotes {
public:
    void add(Label label) { ++m_votes[static_cast<std::size_t>(label)]; }

    LabelVotes& operator+=(const LabelVotes& other) {
        for (std::size_t i = 0; i < m_votes.size(); ++i) m_votes[i] += other.m_votes[i];
        return *this;
    }

    /// Returns the most common label. If several are equally common, returns the last of them in the
    /// enumeration, so that any other label wins against Unlabelled.
    [[nodiscard]] Label commonest() const {
        const auto last = std::max_element(m_votes.rbegin(), m_votes.rend());
        return static_cast<Label>(m_votes.rend() - last - 1);
    }

private:
    std::array<std::uint32_t, LabelCount> m_votes{};
};

}  // namespace leitstand
