#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace leitstand {

/// Where bytes wait that are seldom needed, out of memory. Any thread.
class PageStore {
public:
    PageStore() = default;
    virtual ~PageStore() = default;
    PageStore(const PageStore&) = delete;
    PageStore& operator=(const PageStore&) = delete;

    /// Keeps @p bytes, some at least, and returns how they are asked for; empty: there is no space.
    [[nodiscard]] virtual std::optional<std::uint64_t> put(std::span<const std::byte> bytes) = 0;
    /// Fills @p into with what was put there, as long as it was; false: it cannot be read.
    [[nodiscard]] virtual bool read(std::uint64_t page, std::span<std::byte> into) const = 0;
    /// Nobody asks for @p page, of so many @p bytes, any more.
    virtual void release(std::uint64_t page, std::size_t bytes) = 0;
};

}  // namespace leitstand
