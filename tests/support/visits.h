#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mapping/report_scan.h"

namespace leitstand::test {

/// A visit to the default room of RoomSettings.
struct RoomVisit {
    std::string robot;        ///< "kurt3d@monday"
    int day = 0;              ///< after the first
    bool furnished = true;    ///< pillars, a table, a shelf, a lamp
    std::uint64_t first = 1;  ///< number of its first key scan
    int scans = 3;            ///< 0.4 m apart along the room's middle
};

/// Its key scans, labelled, where they were taken, in the room's frame.
[[nodiscard]] std::vector<ReportScan> scansOf(const RoomVisit& visit);

}  // namespace leitstand::test
