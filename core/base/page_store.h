#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace leitstand {

/// Stores bytes that are rarely needed, outside main memory. Any thread.
class PageStore {
public:
    PageStore() = default;
    virtual ~PageStore() = default;
    PageStore(const PageStore&) = delete;
    PageStore& operator=(const PageStore&) = delete;

    /// Stores @p bytes (at least one) and returns the number of their page. Empty when there is no space.
    [[nodiscard]] virtual std::optional<std::uint64_t> put(std::span<const std::byte> bytes) = 0;
    /// Copies the bytes of @p page to @p into, which must have the same length. Returns false when the page
    /// cannot be read.
    [[nodiscard]] virtual bool read(std::uint64_t page, std::span<std::byte> into) const = 0;
    /// Releases @p page, which has @p bytes bytes. It must not be read any more.
    virtual void release(std::uint64_t page, std::size_t bytes) = 0;
};

}  // namespace leitstand
