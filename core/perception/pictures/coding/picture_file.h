#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/result.h"

namespace leitstand {

enum class PictureFileKind : std::uint8_t { Unknown, Jpeg, Png };

/// What kind of file begins with @p bytes.
[[nodiscard]] PictureFileKind pictureFileKind(std::span<const std::byte> bytes);

/// Size as a picture file's header tells it [px].
struct PictureFileSize {
    std::int64_t width = 0, height = 0;
};

/// Reads the header of a JPEG or PNG file, nothing else. An error when it is neither or has no size.
[[nodiscard]] Result<PictureFileSize> pictureFileSize(std::span<const std::byte> bytes);

}  // namespace leitstand
