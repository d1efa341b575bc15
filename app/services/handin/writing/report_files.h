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

/// Returns the labelled points of @p scans in the map, at most one in each cube with edges of @p edge [m]; 0:
/// all points.
[[nodiscard]] Scan labelledCloud(const std::vector<ReportScan>& scans, double edge);

/// Returns the path of @p robot as a trajectory.
[[nodiscard]] std::vector<TimedPose> trajectoryOf(const ReportRobot& robot);

/// Returns the ending of each robot's trajectory file, for example "_kurt3d.tum"; all are different.
[[nodiscard]] std::vector<std::string> trajectoryEndings(const std::vector<ReportRobot>& robots);

/// What a file should contain, as far as it is known.
struct FileContents {
    /// Number of rows of a list, points of a cloud, or poses of a trajectory; least number of pages of a PDF.
    std::optional<std::size_t> count = {};
    struct Frame {
        int width = 0, height = 0;                          ///< [px]
        Eigen::Vector2d topLeft = Eigen::Vector2d::Zero();  ///< corner of the first pixel in the map [m]
        double perPixel = 0.0;                              ///< edge of a pixel [m]
    };
    std::optional<Frame> frame = {};  ///< for a GeoTIFF
};
[[nodiscard]] FileContents contentsOf(const MapPicture& map);

/// Whether @p file is the list of what was searched, judging by its name: "Name_searched.csv" or
/// "searched.csv", also in capitals.
[[nodiscard]] bool isSearchList(const std::filesystem::path& file);

/// Reads @p file, which writeReport() wrote, and compares it with what it should contain. The file's ending
/// decides how it is read. Returns its content in words; error when something is wrong with it.
[[nodiscard]] Result<std::string> checkFile(const std::filesystem::path& file,
                                            const FileContents& expected = {});

/// Reads the cloud of a map that writeMapCloud() wrote from @p scans. Error when a file in the folder @p out,
/// or the single file @p out, does not have the expected number of points.
[[nodiscard]] Result<void> checkMapCloud(const std::filesystem::path& out,
                                         const std::vector<PlacedScan>& scans);

}  // namespace leitstand
