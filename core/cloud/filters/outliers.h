#pragma once

#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Settings of the search for isolated points.
struct IsolationSettings {
    double radius = 0.10;  ///< a neighbour is nearer than this [m] ...
    double radiusPerRange =
        0.03;  ///< ... or than this share of the point's distance from the sensor, where scans are thin
    int leastNeighbours = 3;  ///< a point with fewer neighbours is isolated
    int threads = 1;          ///< 0: one per core
};

/// Returns @p cloud, in its sensor's frame, without isolated points: dust, reflections, wires.
[[nodiscard]] PointCloud withoutIsolated(const PointCloud& cloud, const IsolationSettings& settings = {});

/// Settings of the search for mixed pixels in organised scans.
struct MixedPixelSettings {
    double leastStep = 0.08;  ///< least range step to the surfaces on both sides [m]; less is noise
    double steepness = 1.5;   ///< least range change per distance across the beams, for both steps
    int widest = 2;           ///< most mixed pixels side by side; more points are an object of their own
};

/// Returns which points of an organised @p scan are mixed pixels, one flag a point; none in unorganised ones.
/// A mixed pixel hangs between foreground and background, where an edge split the beam. Along its row or
/// column the range rises or falls steeply from one side to the other. It continues the surface of neither
/// side.
[[nodiscard]] std::vector<bool> mixedPixels(const Scan& scan, const MixedPixelSettings& settings = {});

/// Returns @p scan with its mixed pixels replaced by points without echo; an unorganised scan stays as it is.
[[nodiscard]] Scan withoutMixedPixels(Scan scan, const MixedPixelSettings& settings = {});

}  // namespace leitstand
