#pragma once

#include <QString>

#include "core/robot/scanner_correction.h"

namespace leitstand {

/// Asks whether the 3D scanner of the robot of title @p robot is to be corrected by @p more.
[[nodiscard]] QString scannerQuestionText(const QString& robot, const ScannerCorrection& more);

}  // namespace leitstand
