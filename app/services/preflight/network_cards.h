#pragma once

#include <string>
#include <vector>

#include "core/station/preflight/preflight.h"

namespace leitstand {

/// Returns the network cards of this computer that have an IPv4 address. Those whose name or address is in
/// @p chosen are used; if it is empty, all that are up.
[[nodiscard]] std::vector<NetworkCard> networkCards(const std::vector<std::string>& chosen);

}  // namespace leitstand
