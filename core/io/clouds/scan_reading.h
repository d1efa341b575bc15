#pragma once

#include <string>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// What a reader made of a file: the scan, and what the operator should know although it could be read.
struct ScanReading {
    Scan scan;
    std::vector<std::string> warnings;  ///< each names its file
};

}  // namespace leitstand
