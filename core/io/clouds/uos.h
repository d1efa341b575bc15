#pragma once

#include <filesystem>
#include <vector>

#include "core/base/pose.h"
#include "core/base/result.h"
#include "core/cloud/scan.h"
#include "core/io/clouds/scan_reading.h"

namespace leitstand {

/// Reads `scanNNN.3d` of 3DTK's format "uos" (left-handed centimetres: x right, y up, z forward). Reads the
/// odometry from `scanNNN.pose` beside it; a missing .pose is a warning. The fourth number of a line is the
/// intensity. The grid is taken from a first line "ROWS x COLUMNS", otherwise from the geometry. Points
/// exactly at the origin and NaN mean no echo.
[[nodiscard]] Result<ScanReading> readUosScan(const std::filesystem::path& file3d);

/// Writes @p scan so that readUosScan() returns the same points, grid, intensities and odometry. Points
/// without echo are written as "0 0 0"; labels are not written. Removes the .pose of an earlier scan when
/// @p scan has no odometry.
[[nodiscard]] Result<void> writeUosScan(const std::filesystem::path& file3d, const Scan& scan);

/// Writes only the points of @p scan, and no .pose.
[[nodiscard]] Result<void> writeUosPoints(const std::filesystem::path& file3d, const Scan& scan);

/// Reads a .pose: x y z [cm], then rotations about x, y, z [degrees] with R = Rx Ry Rz, left-handed.
[[nodiscard]] Result<Pose> readUosPose(const std::filesystem::path& file);
[[nodiscard]] Result<void> writeUosPose(const std::filesystem::path& file, const Pose& pose);

/// A line of a .frames file: the pose of a scan after a step of its registration.
struct UosFrame {
    Pose pose = Pose::Identity();
    int colour = 0;  ///< 3DTK's number for the kind of the step
};

/// Reads a .frames file, 3DTK's result of a registration. Each line holds the 16 numbers of a column-major,
/// left-handed matrix [cm], and a colour. The result is never empty; the last frame is the final pose.
[[nodiscard]] Result<std::vector<UosFrame>> readUosFrames(const std::filesystem::path& file);
[[nodiscard]] Result<void> writeUosFrames(const std::filesystem::path& file,
                                          const std::vector<UosFrame>& frames);

}  // namespace leitstand
