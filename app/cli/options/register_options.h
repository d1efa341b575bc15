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

/// What the user said to `register`.
struct RegisterOptions {
    std::vector<std::filesystem::path> sources;
    RegistrationSettings settings;
    std::vector<double> range = {0.4, 30.0};
    std::string guess = "odometry";   ///< odometry, identity, or a TUM file
    std::filesystem::path posesFile;  ///< empty: not written
    std::string mapFile;              ///< empty: not written; a trailing / asks for a folder of uos scans
    bool closeLoops = false;
    std::filesystem::path byHand;  ///< links that somebody gives, empty: none
    bool json = false;
};

/// Declares the options of design section 6 on @p command; they write into @p options, which must outlive it.
void declareRegisterOptions(CLI::App& command, RegisterOptions& options);

/// The settings with everything resolved that the command line only names, such as the file of --guess.
[[nodiscard]] Result<RegistrationSettings> resolvedSettings(const RegisterOptions& options);

}  // namespace leitstand::cli
