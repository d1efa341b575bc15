#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "widgets/map_view/scene/points/map_colours.h"
#include "widgets/map_view/scene/points/scan_points.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// The values at the ends of a colour ramp: height or range [m], shade of intensity, or age in the unit of
/// SceneAges.
struct ColourRamp {
    double low = 0.0, high = 1.0;

    bool operator==(const ColourRamp&) const = default;
};

/// Returns the colour of @p value on @p ramp.
[[nodiscard]] Rgba onRamp(double value, const ColourRamp& ramp);

/// How a scan's points are coloured. Colours are computed when drawn: a map of one hour has 20 million
/// points, and stored colours would take four bytes each.
struct PointPaint {
    MapColouring colouring = MapColouring::Label;
    Theme theme = Theme::Dark;
    bool paleFloor = false;  ///< whether floor is pale, as in the paper's top view
    ColourRamp ramp;         ///< used if a value determines the colour
    Rgba one;                ///< colour of all points, if the scan determines it
    bool alike = false;      ///< whether all points have the colour `one`, whatever the colouring
    /// Whether points are dimmed, because another scan is in question or changes are shown.
    bool dim = false;
    /// Map's z axis in the scan's frame; used if height determines the colour.
    Eigen::RowVector3d up = Eigen::RowVector3d::Zero();
    /// Height of the scan's origin in the map [m]; used if height determines the colour.
    double height = 0.0;

    /// Returns the colour of the point with index @p point in @p points.
    [[nodiscard]] Rgba colourOf(const ScanPoints& points, std::size_t point) const;
    bool operator==(const PointPaint&) const = default;

private:
    [[nodiscard]] Rgba plainColourOf(const ScanPoints& points, std::size_t point) const;
};

/// Which points of a scan are drawn, and how.
struct PointCloudLook {
    PointPaint paint;
    bool withCeiling = true;
    std::size_t among = 0;  ///< only this many points, from the first in ScanPoints::order on, may be drawn
    std::size_t shown = 0;  ///< number of points that are drawn

    bool operator==(const PointCloudLook&) const = default;
};

/// Returns the look of a scan's points. @p thinned: whether only a third of them is drawn, as for an
/// uncertain scan.
[[nodiscard]] PointCloudLook lookOf(const ScanPoints& points, const PointPaint& paint, bool withCeiling,
                                    bool thinned);

}  // namespace leitstand
