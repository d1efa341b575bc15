#pragma once

#include <QString>

#include "core/robot/scanner_correction.h"

namespace leitstand {

/// Returns the question whether to correct the 3D scanner of the robot with title @p robot by @p more.
[[nodiscard]] QString scannerQuestionText(const QString& robot, const ScannerCorrection& more);

}  // namespace leitstand
