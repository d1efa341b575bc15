#pragma once

#include <string>

#include "core/base/result.h"
#include "core/settings/domain_settings.h"

namespace CLI {
class App;
}

namespace leitstand {

/// Adds the options that all programs in a DDS domain share to @p command. In the help they stand below the
/// heading @p group; empty: among the others. They write into @p options, which must outlive the command.
void addDomainOptions(CLI::App& command, DomainOptions& options, const std::string& group = {});

/// Returns how to join the domain: by @p options, and where these are not set by ROS's environment variables.
/// Errors name the variable whose value is invalid.
[[nodiscard]] Result<DomainSettings> withEnvironment(const DomainOptions& options);

}  // namespace leitstand
