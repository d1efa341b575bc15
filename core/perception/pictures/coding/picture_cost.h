#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/coding/picture_file.h"

namespace leitstand {

/// A picture file that may be decoded.
struct AffordableFile {
    PictureFileSize size;
    std::vector<std::byte> kept;       ///< for a PNG: the chunks that its pixels need; for a JPEG: empty
    std::span<const std::byte> bytes;  ///< what to decode: the file, or @ref kept
};

/// Checks what it would cost to decode the JPEG or PNG @p file, before anything is decoded. Small files may
/// need seconds and gigabytes. Limits the size of the picture and the number of scans of a JPEG, since each
/// scan costs as much as a picture. The data of a PNG must end with the picture. The error names the limit in
/// @p limits that is exceeded. @p file must outlive the result.
[[nodiscard]] Result<AffordableFile> affordableFile(std::span<const std::byte> file,
                                                    const PictureLimits& limits);

}  // namespace leitstand
