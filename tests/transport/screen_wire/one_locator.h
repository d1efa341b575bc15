#pragma once

#include <cstdint>

#include "transport/dds/detail/fastdds.h"

namespace leitstand::test {

/// One locator, to be gone through once.
class OneLocator final : public detail::fastdds::rtps::LocatorsIterator {
public:
    OneLocator(std::uint32_t port, bool end) : m_end(end) { m_locator.port = port; }
    detail::fastdds::rtps::LocatorsIterator& operator++() override {
        m_end = true;
        return *this;
    }
    bool operator==(const detail::fastdds::rtps::LocatorsIterator& other) const override {
        return m_end == static_cast<const OneLocator&>(other).m_end;
    }
    bool operator!=(const detail::fastdds::rtps::LocatorsIterator& other) const override {
        return !(*this == other);
    }
    const detail::fastdds::rtps::Locator_t& operator*() const override { return m_locator; }

private:
    detail::fastdds::rtps::Locator_t m_locator;
    bool m_end;
};

}  // namespace leitstand::test
