#pragma once

#include <filesystem>
#include <functional>

#include "core/base/time.h"
#include "core/perception/pictures/picture.h"

namespace leitstand::test {

/// Gives the pictures of a film (Rgb8) with the time since its beginning, one after the other, to @p take
/// until that says false. Decoded by libavcodec. Throws std::runtime_error for what is no film.
void readFilm(const std::filesystem::path& file, const std::function<bool(const Picture&, Time)>& take);

}  // namespace leitstand::test
