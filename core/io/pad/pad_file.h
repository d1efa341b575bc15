#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/station/pad/pad_bindings.h"

namespace leitstand {

/// Parses the bindings of a gamepad from the YAML @p text of a file called @p name, which a stranger may have
/// written. An action that is not listed has no control. The error has a line for each mistake.
[[nodiscard]] Result<PadBindings> parsePad(std::string_view text, const std::string& name);
/// Reads the bindings in @p file. Errors as in parsePad(), or when it cannot be read.
[[nodiscard]] Result<PadBindings> readPad(const std::filesystem::path& file);

/// Returns YAML that parsePad() reads back; @p pad is the pad's own name, for people.
[[nodiscard]] std::string padText(const PadBindings& bindings, const std::string& pad);
/// Writes @p file whole or not at all; makes its folder when it is missing.
[[nodiscard]] Result<void> writePad(const PadBindings& bindings, const std::string& pad,
                                    const std::filesystem::path& file);

}  // namespace leitstand
