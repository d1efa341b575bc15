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
    std::vector<std::byte> kept;       ///< of a PNG: the chunks that its pixels need; of a JPEG: nothing
    std::span<const std::byte> bytes;  ///< what to decode: the file, or @ref kept
};

/// Checks the cost of the JPEG or PNG @p file before anything of it is decoded. It limits the size of the
/// picture and the scans of a JPEG: each costs as much as a picture. A PNG's data must end with the picture.
/// Small files may cost seconds and gigabytes otherwise. The error names the exceeded bound of @p limits.
/// @p file must outlive the result.
[[nodiscard]] Result<AffordableFile> affordableFile(std::span<const std::byte> file,
                                                    const PictureLimits& limits);

}  // namespace leitstand
