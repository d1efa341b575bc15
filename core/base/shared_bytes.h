#pragma once

#include <cstddef>
#include <memory>
#include <span>

namespace leitstand {

/// A part of a buffer, such as a picture within its message. The buffer exists as long as this part.
struct SharedBytes {
    std::shared_ptr<const void> owner;  ///< the whole buffer
    std::span<const std::byte> bytes;   ///< the part of the buffer
};

}  // namespace leitstand
