#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "transport/dds/node_settings.h"
#include "transport/link/drive_guard.h"

namespace leitstand {

/// What a station passes to the `leitstand-guard` that it starts.
struct GuardArguments {
    NodeSettings network;        ///< only domain, interfaces, peers, multicast, discovery server
    std::filesystem::path keys;  ///< folder with the keys of the station's identity; empty: no security
    /// All except own name, timing and track distance; of the QoS, only reliability and lifespan.
    DriveGuardSettings guard;
};

/// Convert the arguments to words of a command line, and back. Errors name the word and what was expected.
[[nodiscard]] std::vector<std::string> wordsOf(const GuardArguments& arguments);
[[nodiscard]] Result<GuardArguments> guardArgumentsFrom(const std::vector<std::string>& words);
/// Returns the text of `leitstand-guard --help`.
[[nodiscard]] std::string guardHelp();

}  // namespace leitstand
