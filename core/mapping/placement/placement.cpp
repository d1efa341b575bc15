#include "core/mapping/placement/placement.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/mapping/placement/placement_format.h"
#include "core/mapping/placement/wall_fit.h"
#include "core/mapping/placement/wall_map.h"

namespace leitstand {
namespace {

const std::vector<double> Schedule = {0.3, 0.15, 0.1};

double share(double value, double from, double plenty) {
    return std::clamp((value - from) / (plenty - from), 0.0, 1.0);
}

int percent(double value) {
    return static_cast<int>(std::lround(100.0 * value));
}

}  // namespace

Placement placeRobot(const LaserView& view, const LocalMap& local, const Pose& guess,
                     const SearchWindow& window, const PlacementSettings& settings) {
    Placement placed;
    placed.baseInMap = guess;
    if (static_cast<int>(view.points.size()) < settings.leastPoints) {
        placed.how = logged(placement_format::TooFewPoints, view.points.size());
        return placed;
    }
    const WallMap map = wallMap(local, guess, view.low, view.high);
    const Correlation found = correlate(view, map, FlatPose::of(guess), window);
    const WallFit fit = fitToWalls(view, map, found.pose, Schedule);
    placed.overlap = fit.overlap;
    const double contrast = found.score > 0.0 ? 1.0 - found.second / found.score : 0.0;
    // Half of the required overlap gives no certainty; exactly the required one gives some.
    const double meets = share(fit.overlap, 0.5 * settings.leastOverlap, settings.plentyOverlap);
    const double unique = share(contrast, 0.0, settings.plentyContrast);
    const double held = share(fit.direction, 0.0, settings.plentyDirection);
    placed.certainty = meets * unique * held;
    std::string doubt;
    if (fit.overlap < settings.leastOverlap) {
        doubt = logged(placement_format::LittleInMap);
    } else if (placed.certainty < settings.leastCertainty) {
        doubt =
            held <= unique ? logged(placement_format::DirectionOpen) : logged(placement_format::Elsewhere);
    }
    placed.certain = doubt.empty();
    if (!placed.certain) {
        placed.certainty = std::min(placed.certainty, 0.5 * settings.leastCertainty);
        placed.how =
            logged(placement_format::Because, doubt, logged(placement_format::InMap, percent(fit.overlap)));
        return placed;
    }
    placed.baseInMap = fit.pose.standing(map.ground) * view.tilt;
    placed.how = logged(
        placement_format::FromGuess, percent(fit.overlap),
        std::lround(100.0 * (fit.pose.place - guess.translation().head<2>()).norm()),
        std::lround(inDegrees(angleBetween(fit.pose.standing(0.0), FlatPose::of(guess).standing(0.0)))));
    return placed;
}

}  // namespace leitstand
