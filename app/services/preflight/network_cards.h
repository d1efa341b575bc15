#pragma once

#include <string>
#include <vector>

#include "core/station/preflight/preflight.h"

namespace leitstand {

/// The network cards of this computer that have an IPv4 address; those are used whose name or address is one
/// of @p chosen (all that are up, when it is empty).
[[nodiscard]] std::vector<NetworkCard> networkCards(const std::vector<std::string>& chosen);

}  // namespace leitstand
