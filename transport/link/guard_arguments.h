#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "transport/dds/node_settings.h"
#include "transport/link/drive_guard.h"

namespace leitstand {

/// What `leitstand-guard` is told by the station that starts it.
struct GuardArguments {
    NodeSettings network = {};        ///< domain, interfaces, peers, discovery server; no more is told
    std::filesystem::path keys = {};  ///< folder of the station's identity; empty: open
    DriveGuardSettings guard = {};    ///< all but the timing
};

/// As words of a command line, and back. Errors name the word, and what was expected.
[[nodiscard]] std::vector<std::string> wordsOf(const GuardArguments& arguments);
[[nodiscard]] Result<GuardArguments> guardArgumentsFrom(const std::vector<std::string>& words);
/// What `leitstand-guard --help` says.
[[nodiscard]] std::string guardHelp();

}  // namespace leitstand
