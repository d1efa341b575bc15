#pragma once

#include <vector>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// A fair sample of the points shown.
struct SceneStatistics {
    std::vector<Eigen::Vector3d> points;  ///< in the map's frame [m]
    std::vector<double> ranges;           ///< from their scanners [m]
    std::vector<double> shades;           ///< of those whose intensity was told
};
[[nodiscard]] SceneStatistics statisticsOf(const SceneContent& content);

/// Where @p sample fills space, one point a half-metre cube: stray points, seen through a window or in a
/// mirror, do not count, nor how dense the points are.
[[nodiscard]] std::vector<Eigen::Vector3d> filledPlaces(const SceneStatistics& sample);

/// Numbers between which the colours run, rounded; nothing unless coloured by height, range or intensity.
[[nodiscard]] std::optional<ColourRamp> rampOf(const SceneStatistics& sample, MapColouring colouring);
/// The same by age: from the first scan on, to a little beyond the newest, so that few scans change their
/// colour when one comes; nothing without scans.
[[nodiscard]] std::optional<ColourRamp> rampOfAges(const SceneContent& content);

/// Whether a point of the map at @p height [m] with @p label is shown under @p settings.
[[nodiscard]] bool isShown(double height, Label label, const MapViewSettings& settings);

}  // namespace leitstand
