#pragma once

#include <QString>

#include "core/robot/scanner_correction.h"

namespace leitstand {

/// Returns the question whether to correct the range, clock or mounting of a 3D scanner by @p more. @p robot:
/// title of the robot that has it.
[[nodiscard]] QString scannerQuestionText(const QString& robot, const ScannerCorrection& more);

}  // namespace leitstand
