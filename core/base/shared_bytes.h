#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace leitstand {

/// Bytes that stand in a buffer which is kept alive as long as they are: a picture within its message.
struct SharedBytes {
    std::shared_ptr<const void> owner;  ///< of the whole buffer
    std::span<const std::byte> bytes;   ///< the part of it that is meant
};

}  // namespace leitstand
