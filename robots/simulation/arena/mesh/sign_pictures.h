#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// Returns the picture of a sign: a QR code for "qr:TEXT", a diamond with the pictogram of NAME for
/// "hazard:NAME", and a white plate for any other text.
[[nodiscard]] Texture signPicture(std::string_view text);
/// Returns the NAMEs of hazards: "flammable", "explosive", "poison" ...
[[nodiscard]] const std::vector<std::string>& hazardNames();

}  // namespace leitstand::simulation
