#pragma once

#include <filesystem>
#include <string>

#include "core/base/result.h"
#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Keeps the bindings of the operator's gamepads from run to run: a file for each kind of pad, in a folder of
/// the configuration.
class PadMemory {
public:
    /// @p folder: created when something is kept; empty: nothing is kept.
    explicit PadMemory(std::filesystem::path folder);

    /// Returns what was kept for the pad whose maker and model @p guid names (letters and digits). Returns
    /// the defaults of @p layout if there is nothing, or only for another layout. Sets @p warning to why a
    /// file cannot be read; empty: it can.
    [[nodiscard]] PadBindings bindings(const std::string& guid, PadLayout layout, std::string& warning) const;
    /// Keeps @p bindings for the next time; @p name is what the pad calls itself. Errors name the file.
    Result<void> keep(const std::string& guid, const std::string& name, const PadBindings& bindings) const;

private:
    [[nodiscard]] std::filesystem::path fileOf(const std::string& guid) const;

    std::filesystem::path m_folder;
};

}  // namespace leitstand
