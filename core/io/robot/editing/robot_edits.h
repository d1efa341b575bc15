#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "core/base/result.h"
#include "core/robot/robot_measures.h"
#include "core/robot/scanner_correction.h"

namespace leitstand {

// Changes of robots' files that people write and comment: everything else stays as written. Comments within a
// list that is replaced go with it.

/// Returns @p text, which is a robot's file, with @p correction for the sensor @p sensor. Everything else
/// stays as written, comments included. Error when there is no such sensor, or when the file writes it in a
/// way that is not supported here. A person must then write the correction. Errors call the file @p name.
[[nodiscard]] Result<std::string> withCorrection(const std::string& text, const std::string& name,
                                                 const std::string& sensor,
                                                 const ScannerCorrection& correction);
/// Returns the line of a robot's file that holds @p correction.
[[nodiscard]] std::string correctionLine(const ScannerCorrection& correction);

/// Returns @p text, which is a robot's file, with @p measures, to the millimetre and the hundredth of a
/// degree. Errors as above, or because the measures make no sense.
[[nodiscard]] Result<std::string> withMeasures(const std::string& text, const std::string& name,
                                               const RobotMeasures& measures);

/// Changes the text of a robot's file; @p name is the file in errors.
using RobotEdit = std::function<Result<std::string>(const std::string& text, const std::string& name)>;
/// Applies @p edit to the file that a robot was read from, completely or not at all. A file that came with
/// the program is not changed: a copy in the user's folder is, which goes before it. Returns the path of the
/// file that was written. Errors name it.
[[nodiscard]] Result<std::string> editRobotFile(const std::filesystem::path& file, const RobotEdit& edit);

}  // namespace leitstand
