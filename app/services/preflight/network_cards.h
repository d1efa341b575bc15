#pragma once

#include <string>
#include <vector>

#include "core/station/preflight/preflight.h"

namespace leitstand {

/// Returns the network cards of this computer that have an IPv4 address. Those whose name or address is one
/// of @p chosen are used (all that are up, when it is empty).
[[nodiscard]] std::vector<NetworkCard> networkCards(const std::vector<std::string>& chosen);

}  // namespace leitstand
