#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Texts in a picture file, with their keywords ("Title"; 1 to 79 ASCII letters).
using PictureTexts = std::vector<std::pair<std::string, std::string>>;

/// Encodes @p picture as a PNG file without changing its values (Grey16 in 16 bits). The @p texts (UTF-8) are
/// stored in chunks that every PNG reader knows (iTXt; PNG 1.2, 4.2.3.3). Error for Float32, which PNG cannot
/// store, and for pictures without pixels.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const Picture& picture,
                                                       const PictureTexts& texts = {});

}  // namespace leitstand
