#pragma once

#include "core/base/result.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand::fuzz {

/// What holds for every scan that a reader returns, and that an error tells something.
void checkReading(const Result<ScanReading>& read);

}  // namespace leitstand::fuzz
