#pragma once

#include <string>

#include "core/base/result.h"
#include "core/settings/domain_settings.h"
#include "transport/dds/node_settings.h"

namespace leitstand {

/// Converts @p settings to those of the network node, for a participant called @p name. Errors name the file
/// that makes the identity unusable.
[[nodiscard]] Result<NodeSettings> nodeSettings(const DomainSettings& settings, const std::string& name);

/// Returns whether others in the domain must prove who they are.
[[nodiscard]] bool isSecured(const DomainSettings& settings);
/// Returns a line for the operator that says whether the domain is secured.
[[nodiscard]] std::string securityLine(const DomainSettings& settings);

}  // namespace leitstand
