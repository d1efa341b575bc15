#pragma once

#include <vector>

#include "core/cloud/scan.h"

namespace leitstand {

/// Which points of a cloud are isolated.
struct IsolationSettings {
    double radius = 0.10;  ///< neighbours are nearer than this [m] ...
    double radiusPerRange =
        0.03;                 ///< ... or than this times the distance from the sensor, where scans are thin
    int leastNeighbours = 3;  ///< points with fewer are isolated
    int threads = 1;          ///< 0: one per core
};

/// @p cloud, in its sensor's frame, without isolated points: dust, reflections, wires.
[[nodiscard]] PointCloud withoutIsolated(const PointCloud& cloud, const IsolationSettings& settings = {});

/// Which points of an organised scan are mixed pixels.
struct MixedPixelSettings {
    double leastStep = 0.08;  ///< of range off the surfaces on both sides; less is noise [m]
    double steepness = 1.5;   ///< of the steps on both sides: change of range over distance across the beams
    int widest = 2;           ///< points hanging side by side; more are an object of its own
};

/// Tells the points of an organised @p scan that hang between foreground and background, where a beam was
/// split by an edge: along a row or a column the surface through them would run along the beams on both
/// sides, and they continue neither surface there. One a point.
[[nodiscard]] std::vector<bool> mixedPixels(const Scan& scan, const MixedPixelSettings& settings = {});

/// @p scan with its mixed pixels turned into no echo; unorganised scans stay as they are.
[[nodiscard]] Scan withoutMixedPixels(Scan scan, const MixedPixelSettings& settings = {});

}  // namespace leitstand
