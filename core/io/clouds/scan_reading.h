#pragma once

#include <string>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// A scan read from a file, with warnings for the operator.
struct ScanReading {
    Scan scan;
    std::vector<std::string> warnings;  ///< each warning names its file
};

}  // namespace leitstand
