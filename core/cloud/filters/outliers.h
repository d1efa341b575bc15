#pragma once

#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Settings of the search for isolated points.
struct IsolationSettings {
    double radius = 0.10;  ///< neighbours are nearer than this [m] ...
    double radiusPerRange =
        0.03;                 ///< ... or than this times the distance from the sensor, where scans are thin
    int leastNeighbours = 3;  ///< points with fewer are isolated
    int threads = 1;          ///< 0: one per core
};

/// Returns @p cloud, in its sensor's frame, without isolated points: dust, reflections, wires.
[[nodiscard]] PointCloud withoutIsolated(const PointCloud& cloud, const IsolationSettings& settings = {});

/// Settings of the search for mixed pixels in organised scans.
struct MixedPixelSettings {
    double leastStep = 0.08;  ///< least step of range from the surfaces on both sides; less is noise [m]
    double steepness = 1.5;   ///< least change of range over distance across the beams, of both steps
    int widest = 2;           ///< points hanging side by side; more are an object of its own
};

/// Returns which points of an organised @p scan are mixed pixels, one flag a point. Such a point hangs
/// between foreground and background, where an edge split the beam. Along a row or a column the surface
/// through it would run along the beams on both sides, and it continues neither surface there.
[[nodiscard]] std::vector<bool> mixedPixels(const Scan& scan, const MixedPixelSettings& settings = {});

/// Returns @p scan with no echo in place of its mixed pixels; unorganised scans stay as they are.
[[nodiscard]] Scan withoutMixedPixels(Scan scan, const MixedPixelSettings& settings = {});

}  // namespace leitstand
