#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/io/tum.h"
#include "core/mission/report/report_model.h"

namespace leitstand {

/// The labelled points of @p scans in the map, one for each cube of @p edge [m]; 0: all.
[[nodiscard]] Scan labelledCloud(const std::vector<ReportScan>& scans, double edge);

/// The way of @p robot as a trajectory.
[[nodiscard]] std::vector<TimedPose> trajectoryOf(const ReportRobot& robot);

/// How the name of each robot's trajectory ends, "_kurt3d.tum"; no two are the same.
[[nodiscard]] std::vector<std::string> trajectoryEndings(const std::vector<ReportRobot>& robots);

/// Reads @p file of a report again, whatever its ending says that it is: what is in it in words, or what is
/// wrong with it. For files that writeReport() writes.
[[nodiscard]] Result<std::string> checkFile(const std::filesystem::path& file);

}  // namespace leitstand
