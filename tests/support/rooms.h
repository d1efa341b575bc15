#pragma once

#include <cstddef>
#include <vector>

#include "core/base/pose.h"
#include "core/cloud/scan.h"

namespace leitstand::test {

/// A generated room with exact truth: a box with pillars, a table, a shelf and a lamp, seen by a scanner.
struct RoomSettings {
    double length = 8.0, width = 6.0, height = 2.6;  ///< [m]; the room's frame: origin in the middle of the
                                                     ///< floor, x along length
    bool furnished = true;                           ///< pillars, a table, a shelf, a lamp
    Pose sensorInRoom = poseFrom({0, 0, 1.0}, 0, 0, 0);
    Sweep sweep = Sweep::Tilting;
    int rows = 226, columns = 360;  ///< Tilting: rows tilts from -48 (down) to +68 degrees, columns 180
                                    ///< degrees across from the right; Yawing: rows headings over 360 degrees
                                    ///< from the back, columns elevations from -70 to +90 degrees
    double rangeNoise = 0.01;       ///< sigma [m]
    unsigned seed = 1;              ///< of the noise
};

/// What the scanner measured, and the truth about every point.
struct RoomScan {
    Scan scan;                      ///< in the sensor's frame, organised, NaN where nothing was hit;
                                    ///< sensorInOdom = sensorInRoom, hasOdometry true
    std::vector<Label> trueLabels;  ///< by the surface: horizontal seen from above (floor, table tops) Floor,
                                    ///< from below Ceiling, vertical Wall, no echo Unlabelled
    std::vector<float> edgeDistances;  ///< of the true hit from the nearest border of its planar face or
                                       ///< the nearest other body; 0 without echo [m]
};

/// One sweep of a scanner at @p settings.sensorInRoom, which must be free space inside the room.
[[nodiscard]] RoomScan scanRoom(const RoomSettings& settings = {});

/// A corridor 2 m wide, `length` long, without furniture, its ends open: no echo from beyond.
[[nodiscard]] RoomScan scanCorridor(const RoomSettings& settings);

/// @p n points spread evenly over the surfaces of the furnished default room, room frame, with normals (into
/// free space) and labels, free of noise.
[[nodiscard]] PointCloud roomCloud(std::size_t n, unsigned seed);

/// @p cloud with @p pose applied to points and normals.
[[nodiscard]] PointCloud moved(const Pose& pose, const PointCloud& cloud);

}  // namespace leitstand::test
