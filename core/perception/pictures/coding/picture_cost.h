#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/perception/pictures/coding/picture_decoding.h"
#include "core/perception/pictures/coding/picture_file.h"

namespace leitstand {

/// A picture's file that may be decoded.
struct AffordableFile {
    PictureFileSize size;
    std::vector<std::byte> kept;       ///< of a PNG: the chunks that its pixels need; of a JPEG: nothing
    std::span<const std::byte> bytes;  ///< what to decode: the file, or @ref kept
};

/// Judges the JPEG or PNG @p file before anything of it is decoded: how large the picture gets, how often a
/// JPEG goes over it (each scan costs as much as a picture), and that a PNG's data end with the picture.
/// Small files may cost seconds and gigabytes otherwise. An error tells which bound of @p limits is passed.
/// @p file must outlive the result.
[[nodiscard]] Result<AffordableFile> affordableFile(std::span<const std::byte> file,
                                                    const PictureLimits& limits);

}  // namespace leitstand
