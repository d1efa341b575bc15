#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// What the operator's gamepads do, kept from run to run: a file for each kind of pad, in a folder of the
/// configuration.
class PadMemory {
public:
    /// @p folder: made when something is to be kept; empty: nothing is kept.
    explicit PadMemory(std::filesystem::path folder);

    /// What was kept for the pad whose maker and model @p guid names (letters and digits), or what @p layout
    /// usually does. @p warning gets why a file that is there is not used.
    [[nodiscard]] PadBindings bindings(const std::string& guid, PadLayout layout, std::string& warning) const;
    /// Keeps @p bindings for the next time; @p name is what the pad calls itself. Errors name the file.
    Result<void> keep(const std::string& guid, const std::string& name, const PadBindings& bindings) const;

private:
    [[nodiscard]] std::filesystem::path fileOf(const std::string& guid) const;

    std::filesystem::path m_folder;
};

}  // namespace leitstand
