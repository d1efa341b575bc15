#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace leitstand {

/// Stores bytes that are seldom needed, out of memory. Any thread.
class PageStore {
public:
    PageStore() = default;
    virtual ~PageStore() = default;
    PageStore(const PageStore&) = delete;
    PageStore& operator=(const PageStore&) = delete;

    /// Stores @p bytes (at least one) and returns the number of their page; empty when there is no space.
    [[nodiscard]] virtual std::optional<std::uint64_t> put(std::span<const std::byte> bytes) = 0;
    /// Fills @p into, as long as the bytes that were put, with @p page; false when it cannot be read.
    [[nodiscard]] virtual bool read(std::uint64_t page, std::span<std::byte> into) const = 0;
    /// Releases @p page of @p bytes bytes, which nobody reads any more.
    virtual void release(std::uint64_t page, std::size_t bytes) = 0;
};

}  // namespace leitstand
