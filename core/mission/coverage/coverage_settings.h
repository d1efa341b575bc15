#pragma once

#include <cstddef>

#include "core/base/pose.h"

namespace leitstand {

/// When a place counts as searched: where a body that lies there would be seen.
struct CoverageSettings {
    double cell = 0.1;           ///< of the grid, at least [m]
    double bodyMiddle = 0.15;    ///< of a body that lies, above the floor [m]
    double bodyArea = 0.15;      ///< that a scanner sees of it, 0.5 m x 0.3 m [m2]
    double bodySide = 0.4;       ///< that cameras see of it [m]
    double scannerPoints = 20;   ///< of a scan of the map that have to be on it
    double cameraPixels = 24;    ///< that it has to span
    double infraredPixels = 8;   ///< likewise
    double scannerReach = 8.0;   ///< beyond, a scan is not looked at [m]
    double cameraReach = 5.0;    ///< beyond, nobody looks for motion, codes and placards [m]
    double infraredReach = 6.0;  ///< beyond, nobody looks for warmth [m]
    double sure = 4.0;           ///< so many times what is needed is as good as it gets

    double lowest = 0.12;       ///< what is higher above the floor is in the way [m]
    double robotHeight = 0.65;  ///< what is lower too is in the robots' way [m]
    double robotRadius = 0.2;   ///< of the narrowest robot [m]
    double leastMissed = 0.25;  ///< regions that are smaller are not worth a way [m2]

    double viewApart = 0.10;            ///< views nearer than this [m] ...
    double viewTurned = degrees(5);     ///< ... and this are one [rad]
    double coarsest = 4.0;              ///< where there are too many views, so many times that is one
    std::size_t mostViewsOfScan = 600;  ///< that hang on a scan
    std::size_t mostViews = 20'000;
    double scanCell = 0.08;  ///< a point of a scan is kept for each cube of this edge [m]
    double scanReach = 20;   ///< ... and none that is farther from the scanner [m]
};

}  // namespace leitstand
