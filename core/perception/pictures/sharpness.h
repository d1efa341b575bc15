#pragma once

#include "core/perception/pictures/picture.h"

namespace leitstand {

/// How sharp @p picture is, in grey levels squared: the variance of its Laplacian on a picture of at most 320
/// pixels' width (Pech-Pacheco et al. 2000). Only pictures of one camera compare. 0 for empty ones.
[[nodiscard]] double sharpness(const Picture& picture);

}  // namespace leitstand
