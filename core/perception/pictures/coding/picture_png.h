#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Texts of a picture, by keyword ("Title", 1 to 79 letters of ASCII).
using PictureTexts = std::vector<std::pair<std::string, std::string>>;

/// Encodes @p picture as a PNG file with its values unchanged (Grey16 in 16 bits). The @p texts (UTF-8) go
/// into chunks that every reader of PNG knows (iTXt; PNG 1.2, 4.2.3.3). Error for Float32, which PNG does not
/// have, and for pictures without pixels.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const Picture& picture,
                                                       const PictureTexts& texts = {});

}  // namespace leitstand
