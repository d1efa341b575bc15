#pragma once

#include <vector>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// A fair sample of the points that are shown.
struct SceneStatistics {
    std::vector<Eigen::Vector3d> points;  ///< in the map's frame [m]
    std::vector<double> ranges;           ///< distances of points from their scanners [m]
    std::vector<double> shades;           ///< shades of points that have an intensity
};
[[nodiscard]] SceneStatistics statisticsOf(const SceneContent& content);

/// Returns one point of @p sample for each occupied half-metre cube, whatever the density. Isolated points,
/// seen through a window or in a mirror, are left out.
[[nodiscard]] std::vector<Eigen::Vector3d> filledPlaces(const SceneStatistics& sample);

/// Returns the rounded values at the ends of the colours. Empty unless height, range or intensity determines
/// the colours.
[[nodiscard]] std::optional<ColourRamp> rampOf(const SceneStatistics& sample, MapColouring colouring);
/// Returns the ramp of ages, from the first scan to slightly beyond the newest, so that a new scan changes
/// few colours. Empty without scans.
[[nodiscard]] std::optional<ColourRamp> rampOfAges(const SceneContent& content);

/// Whether a point of the map at @p height [m] with @p label is shown under @p settings.
[[nodiscard]] bool isShown(double height, Label label, const MapViewSettings& settings);

}  // namespace leitstand
