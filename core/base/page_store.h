#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace leitstand {

/// Keeps bytes that are seldom needed, outside of main memory. Any thread.
class PageStore {
public:
    PageStore() = default;
    virtual ~PageStore() = default;
    PageStore(const PageStore&) = delete;
    PageStore& operator=(const PageStore&) = delete;

    /// Stores @p bytes (at least one) and returns the number of their page; empty when there is no space.
    [[nodiscard]] virtual std::optional<std::uint64_t> put(std::span<const std::byte> bytes) = 0;
    /// Copies the bytes of @p page to @p into, which must be as long as the bytes that were put. Returns
    /// false when the page cannot be read.
    [[nodiscard]] virtual bool read(std::uint64_t page, std::span<std::byte> into) const = 0;
    /// Releases @p page of @p bytes bytes; nobody may read it afterwards.
    virtual void release(std::uint64_t page, std::size_t bytes) = 0;
};

}  // namespace leitstand
