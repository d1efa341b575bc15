#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Parses the bindings of a gamepad from YAML @p text. The text may be untrusted; errors call the file
/// @p name. An action that is not listed has no control. The error has a line for each mistake.
[[nodiscard]] Result<PadBindings> parsePad(std::string_view text, const std::string& name);
/// Reads the bindings in @p file. Errors are those of parsePad(), or that the file cannot be read.
[[nodiscard]] Result<PadBindings> readPad(const std::filesystem::path& file);

/// Returns @p bindings as YAML for parsePad(). @p pad: the pad's own name, written for people.
[[nodiscard]] std::string padText(const PadBindings& bindings, const std::string& pad);
/// Writes @p file completely or not at all. Makes its folder when it is missing.
[[nodiscard]] Result<void> writePad(const PadBindings& bindings, const std::string& pad,
                                    const std::filesystem::path& file);

}  // namespace leitstand
