#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/mapping/registration_settings.h"

namespace CLI {
class App;
}

namespace leitstand::cli {

/// Arguments of `register`.
struct RegisterOptions {
    std::vector<std::filesystem::path> sources;
    RegistrationSettings settings;
    std::vector<double> range = {0.4, 30.0};
    std::string guess = "odometry";   ///< odometry, identity, or a TUM file
    std::filesystem::path posesFile;  ///< empty: not written
    std::string mapFile;              ///< empty: not written; a trailing / asks for a folder of uos scans
    bool closeLoops = false;
    std::filesystem::path byHand;  ///< file of links given by hand; empty: none
    bool json = false;
};

/// Declares the options of `register` (docs/design.md, "Command lines") on @p command. They write into
/// @p options, which must outlive the command.
void declareRegisterOptions(CLI::App& command, RegisterOptions& options);

/// Returns the settings of @p options, with ranges set and the file of --guess read. Error when that file
/// cannot be read.
[[nodiscard]] Result<RegistrationSettings> resolvedSettings(const RegisterOptions& options);

}  // namespace leitstand::cli
