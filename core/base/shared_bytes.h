#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace leitstand {

/// A part of a buffer, which stays alive as long as this refers to it: a picture within its message.
struct SharedBytes {
    std::shared_ptr<const void> owner;  ///< the whole buffer
    std::span<const std::byte> bytes;   ///< the part of it
};

}  // namespace leitstand
