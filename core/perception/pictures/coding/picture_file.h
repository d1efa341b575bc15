#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/result.h"

namespace leitstand {

enum class PictureFileKind : std::uint8_t { Unknown, Jpeg, Png };

/// Returns the kind of a picture file, which begins with @p bytes.
[[nodiscard]] PictureFileKind pictureFileKind(std::span<const std::byte> bytes);

/// Size of a picture, from the header of its file [px].
struct PictureFileSize {
    std::int64_t width = 0, height = 0;
};

/// Reads the size from the header of a JPEG or PNG file. Error when it is neither, or its header has no size.
[[nodiscard]] Result<PictureFileSize> pictureFileSize(std::span<const std::byte> bytes);

}  // namespace leitstand
