#pragma once

#include "app/services/domain/domain_settings.h"

namespace CLI {
class App;
}

namespace leitstand::cli {

/// The options of every command that takes part in a domain, which fill @p settings.
void addDomainOptions(CLI::App& command, DomainSettings& settings);

}  // namespace leitstand::cli
