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
    std::string guess = "odometry";   ///< "odometry", "identity", or a TUM file
    std::filesystem::path posesFile;  ///< empty: not written
    std::string mapFile;              ///< empty: not written; with a trailing /: a folder of uos scans
    bool closeLoops = false;
    std::filesystem::path byHand;  ///< file with links made by hand; empty: none
    bool json = false;
};

/// Adds the options of `register` (docs/design.md, "Command lines") to @p command. They write to @p options,
/// which must outlive the command.
void declareRegisterOptions(CLI::App& command, RegisterOptions& options);

/// Returns the settings in @p options, after setting the ranges and reading the file of --guess. Error when
/// that file cannot be read.
[[nodiscard]] Result<RegistrationSettings> resolvedSettings(const RegisterOptions& options);

}  // namespace leitstand::cli
