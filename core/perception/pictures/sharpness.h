#pragma once

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// Returns the sharpness of @p picture in squared grey levels: the variance of its Laplacian, at a width of
/// at most 320 pixels (Pech-Pacheco et al. 2000). Comparable only between pictures of the same camera. 0 for
/// empty pictures.
[[nodiscard]] double sharpness(const Picture& picture);

}  // namespace leitstand
