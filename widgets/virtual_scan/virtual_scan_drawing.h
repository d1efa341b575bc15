#pragma once

#include <vector>

#include <QPainter>
#include <QPointF>
#include <QRectF>

#include "core/perception/surroundings/virtual_scan_view.h"
#include "widgets/models/live/robots/proximity.h"
#include "widgets/models/live/view_geometry.h"
#include "widgets/painting/theme.h"

namespace leitstand {

/// Draws the surroundings of a robot in base_link, with x up.
class VirtualScanDrawing {
public:
    /// @p origin: where base_link is [px]. @p scale: [px/m]. @p grey: whether to draw without colours.
    VirtualScanDrawing(QPainter& painter, const ThemeColours& colours, const QPointF& origin, double scale,
                       bool grey);

    /// Draws range rings with their radii as text; no text is drawn in @p taken.
    void rings(const QRectF& area, double range, const QRectF& taken) const;
    /// @p withLaser: whether to draw also the points of planar lasers, below the contours. If there are no
    /// other scanners, the contours come from these points.
    void surroundings(const VirtualScanView& view, bool withLaser) const;
    void path(const PredictedPath& path) const;
    void robot(const std::vector<Eigen::Vector2d>& footprint, const BodyBox& body) const;
    /// Draws a ring around @p nearest and the distance as text.
    void nearest(const Proximity& nearest, const QRectF& area) const;

    /// Returns the box of the text that nearest() draws [px]; empty when @p nearest has no place.
    [[nodiscard]] QRectF nearestBox(const Proximity& nearest, const QRectF& area) const;
    [[nodiscard]] QPointF pixelOf(const Eigen::Vector2d& point) const;

private:
    [[nodiscard]] QColor ink(QColor colour, double alpha = 1.0) const;
    void freeSpace(const VirtualScanView& view) const;
    void laser(const VirtualScanView& view) const;
    void walls(const VirtualScanView& view) const;
    void obstacles(const VirtualScanView& view) const;

    QPainter& m_painter;
    const ThemeColours& m_colours;
    QPointF m_origin;
    double m_scale;
    bool m_grey;
};

}  // namespace leitstand
