#pragma once

#include "app/services/domain/domain_settings.h"

namespace CLI {
class App;
}

namespace leitstand::cli {

/// Adds the options of every command that takes part in a domain to @p command. They write into @p settings,
/// which must outlive it.
void addDomainOptions(CLI::App& command, DomainSettings& settings);

}  // namespace leitstand::cli
