#pragma once

#include <cstddef>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "widgets/map_view/scene/points/map_colours.h"
#include "widgets/map_view/scene/points/scan_points.h"
#include "widgets/models/map/map_view_settings.h"

namespace leitstand {

/// The numbers at the ends of a colour ramp: [m] of height and range, shades of intensity, SceneAges.
struct ColourRamp {
    double low = 0.0, high = 1.0;

    bool operator==(const ColourRamp&) const = default;
};

/// The colour of @p value on @p ramp.
[[nodiscard]] Rgba onRamp(double value, const ColourRamp& ramp);

/// How the points of a scan are coloured. The colour of each is worked out where it is drawn: an hour's map
/// has 20 million points, and their colours would take four bytes each.
struct PointPaint {
    MapColouring colouring = MapColouring::Label;
    Theme theme = Theme::Dark;
    bool paleFloor = false;  ///< as the paper's top view has it
    ColourRamp ramp;         ///< where a number decides
    Rgba one;                ///< of all points, where the scan decides
    bool alike = false;      ///< all points have that one, whatever decides otherwise
    bool dim = false;        ///< another scan is in question
    Eigen::RowVector3d up =
        Eigen::RowVector3d::Zero();  ///< the map's, in the scan's frame; where height decides
    double height = 0.0;             ///< of the scan's origin [m], likewise

    /// Of the @p point -th of @p points.
    [[nodiscard]] Rgba colourOf(const ScanPoints& points, std::size_t point) const;
    bool operator==(const PointPaint&) const = default;

private:
    [[nodiscard]] Rgba plainColourOf(const ScanPoints& points, std::size_t point) const;
};

/// How the points of a scan are drawn, and which.
struct PointCloudLook {
    PointPaint paint;
    bool withCeiling = true;
    std::size_t among = 0;  ///< those drawn are among the first so many of the scan's order ...
    std::size_t shown = 0;  ///< ... and are so many

    bool operator==(const PointCloudLook&) const = default;
};

/// Of all points of a scan, or where @p thinned of some of them.
[[nodiscard]] PointCloudLook lookOf(const ScanPoints& points, const PointPaint& paint, bool withCeiling,
                                    bool thinned);

}  // namespace leitstand
