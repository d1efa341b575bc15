#pragma once

#include <algorithm>
#include <map>
#include <vector>

#include "core/base/page_store.h"

namespace leitstand::test {

/// A store that can be full or broken, and tells how often it was asked. One thread.
class PageMemory final : public PageStore {
public:
    std::optional<std::uint64_t> put(std::span<const std::byte> bytes) override {
        if (full) return std::nullopt;
        ++puts;
        pages.emplace(++m_last, std::vector<std::byte>(bytes.begin(), bytes.end()));
        return m_last;
    }
    bool read(std::uint64_t page, std::span<std::byte> into) const override {
        ++reads;
        const auto found = pages.find(page);
        if (unreadable || found == pages.end() || found->second.size() != into.size()) return false;
        std::copy(found->second.begin(), found->second.end(), into.begin());
        return true;
    }
    void release(std::uint64_t page, std::size_t bytes) override {
        if (const auto found = pages.find(page); found != pages.end() && found->second.size() == bytes)
            pages.erase(found);
    }

    std::map<std::uint64_t, std::vector<std::byte>> pages;
    bool full = false, unreadable = false;
    int puts = 0;
    mutable int reads = 0;

private:
    std::uint64_t m_last = 0;
};

}  // namespace leitstand::test
