#pragma once

#include <string>

#include "core/base/result.h"
#include "core/settings/domain_settings.h"

namespace CLI {
class App;
}

namespace leitstand {

/// Adds the options that all programs in a DDS domain share to @p command. The help lists them below the
/// heading @p group; empty: together with the other options. They write to @p options, which must outlive the
/// command.
void addDomainOptions(CLI::App& command, DomainOptions& options, const std::string& group = {});

/// Returns how to join the domain, according to @p options. Where these are not set, ROS's environment
/// variables are used. Errors name the variable whose value is invalid.
[[nodiscard]] Result<DomainSettings> withEnvironment(const DomainOptions& options);

}  // namespace leitstand
