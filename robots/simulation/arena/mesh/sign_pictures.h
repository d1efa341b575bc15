#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "robots/simulation/arena/mesh.h"

namespace leitstand::simulation {

/// What a sign shows: "qr:TEXT" a QR code, "hazard:NAME" a diamond with the pictogram of NAME. Anything else:
/// a white plate.
[[nodiscard]] Texture signPicture(std::string_view text);
/// The NAMEs: "flammable", "explosive", "poison" ...
[[nodiscard]] const std::vector<std::string>& hazardNames();

}  // namespace leitstand::simulation
