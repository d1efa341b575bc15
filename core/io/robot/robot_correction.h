#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/robot/scanner_correction.h"

namespace leitstand {

/// The robot's file @p text, named @p name in errors, with @p correction for its sensor @p sensor; all else,
/// comments too, stays as it was written. Errors, in words: there is no such sensor, or it is written in a
/// way that is not known here, so that the correction has to be written by hand.
[[nodiscard]] Result<std::string> withCorrection(const std::string& text, const std::string& name,
                                                 const std::string& sensor,
                                                 const ScannerCorrection& correction);

/// The line of a robot's file that says @p correction.
[[nodiscard]] std::string correctionLine(const ScannerCorrection& correction);

}  // namespace leitstand
