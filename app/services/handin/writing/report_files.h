#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/handin/map/map_painter.h"
#include "core/handin/report_model.h"
#include "core/io/clouds/cloud_writer.h"
#include "core/io/clouds/tum.h"

namespace leitstand {

/// The labelled points of @p scans in the map, one for each cube of @p edge [m]; 0: all.
[[nodiscard]] Scan labelledCloud(const std::vector<ReportScan>& scans, double edge);

/// The way of @p robot as a trajectory.
[[nodiscard]] std::vector<TimedPose> trajectoryOf(const ReportRobot& robot);

/// How the name of each robot's trajectory ends, "_kurt3d.tum"; no two are the same.
[[nodiscard]] std::vector<std::string> trajectoryEndings(const std::vector<ReportRobot>& robots);

/// What a file is to hold, as far as somebody knows.
struct FileContents {
    /// Rows of a list, points of a cloud, poses of a trajectory; pages that a PDF has at least.
    std::optional<std::size_t> count = {};
    struct Frame {
        int width = 0, height = 0;                          ///< [px]
        Eigen::Vector2d topLeft = Eigen::Vector2d::Zero();  ///< of the first pixel's corner, in the map [m]
        double perPixel = 0.0;                              ///< [m]
    };
    std::optional<Frame> frame = {};  ///< of a GeoTIFF
};
[[nodiscard]] FileContents contentsOf(const MapPicture& map);

/// Whether @p file is the list of what was searched by its name, "Name_searched.csv" or "searched.csv", in
/// capitals too.
[[nodiscard]] bool isSearchList(const std::filesystem::path& file);

/// Reads @p file of a report again, whatever its ending says that it is, and compares it with what it is to
/// hold: what is in it in words, or what is wrong with it. For files that writeReport() writes.
[[nodiscard]] Result<std::string> checkFile(const std::filesystem::path& file,
                                            const FileContents& expected = {});

/// Reads a map's cloud again that writeMapCloud() wrote, of which @p scans are the parts: that its points are
/// as many, in each file of a folder.
[[nodiscard]] Result<void> checkMapCloud(const std::filesystem::path& out,
                                         const std::vector<PlacedScan>& scans);

}  // namespace leitstand
