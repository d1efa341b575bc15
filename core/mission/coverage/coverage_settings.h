#pragma once

#include <cstddef>

#include "core/base/pose.h"

namespace leitstand {

/// When a place counts as searched: if a body were lying there, it would have been seen.
struct CoverageSettings {
    double cell = 0.1;          ///< smallest edge of a grid cell; large maps have larger cells [m]
    double bodyMiddle = 0.15;   ///< height of a lying body's middle above the floor [m]
    double bodyArea = 0.15;     ///< area of the body that a scanner sees, 0.5 m x 0.3 m [m2]
    double bodySide = 0.4;      ///< side of the body that cameras see [m]
    double scannerPoints = 20;  ///< points of a key scan that must lie on the body
    double cameraPixels = 24;   ///< pixels that the body must span in a camera picture
    double infraredPixels = 8;  ///< pixels that the body must span in an infrared picture
    double scannerReach = 8.0;  ///< range up to which scans are used [m]
    /// Range up to which cameras are used to look for motion, codes and placards [m].
    double cameraReach = 5.0;
    double infraredReach = 6.0;  ///< range up to which infrared cameras are used to look for warmth [m]
    double sure = 4.0;           ///< a place is seen best with this multiple of the required points or pixels

    double lowest = 0.12;       ///< things higher than this above the floor block the view [m]
    double robotHeight = 0.65;  ///< things that begin lower than this also block robots [m]
    double robotRadius = 0.2;   ///< radius of the narrowest robot [m]
    double leastMissed = 0.25;  ///< smaller regions are not reported [m2]

    double viewApart = 0.10;  ///< views whose cameras are nearer than this count as the same view [m] ...
    double viewTurned = degrees(5);     ///< ... if they are also turned by less than this [rad]
    double coarsest = 4.0;              ///< largest factor for both thresholds when there are too many views
    std::size_t mostViewsOfScan = 600;  ///< largest number of views per scan
    std::size_t mostViews = 20'000;
    double scanCell = 0.08;  ///< one point of a scan is kept per cube of this edge [m]
    double scanReach = 20;   ///< points farther from the scanner are dropped [m]
};

}  // namespace leitstand
