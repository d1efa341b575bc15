#pragma once

#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Settings for finding isolated points.
struct IsolationSettings {
    double radius = 0.10;  ///< a neighbour is nearer than this [m] ...
    /// ... or nearer than this share of the point's distance from the sensor, where scans are thin.
    double radiusPerRange = 0.03;
    int leastNeighbours = 3;  ///< a point with fewer neighbours is isolated
    int threads = 1;          ///< number of threads; 0: one per core
};

/// Returns @p cloud, in its sensor's frame, without isolated points: dust, reflections, wires.
[[nodiscard]] PointCloud withoutIsolated(const PointCloud& cloud, const IsolationSettings& settings = {});

/// Settings for finding mixed pixels in organised scans.
struct MixedPixelSettings {
    double leastStep = 0.08;  ///< least range step to the surfaces on both sides [m]; a smaller step is noise
    /// Both steps must change the range by at least this per distance across the beams.
    double steepness = 1.5;
    int widest = 2;  ///< largest number of mixed pixels side by side; more points are a separate object
};

/// Returns which points of an organised @p scan are mixed pixels, one flag per point; unorganised scans have
/// none. A mixed pixel is between foreground and background, where an edge split the beam. Along its row or
/// column, the range rises or falls steeply from one side to the other. The point continues the surface of
/// neither side.
[[nodiscard]] std::vector<bool> mixedPixels(const Scan& scan, const MixedPixelSettings& settings = {});

/// Returns @p scan with its mixed pixels replaced by points without echo. An unorganised scan is not changed.
[[nodiscard]] Scan withoutMixedPixels(Scan scan, const MixedPixelSettings& settings = {});

}  // namespace leitstand
