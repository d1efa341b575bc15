#include "widgets/map_view/scene/points/drawn_points.h"

#include <algorithm>

namespace leitstand {

template <typename Take>
void ShownPoints::next(std::size_t count, Take take) {
    const PointCloudLook& look = *m_scan->look;
    const ScanPoints& points = *m_scan->points;
    const bool all = look.shown == look.among;
    for (; count > 0 && m_at < look.among; ++m_at) {
        const std::size_t point = (*points.order)[m_at];
        if (!all && points.labels[point] == Label::Ceiling) continue;
        take(point);
        --count;
    }
}

void ShownPoints::skip(std::size_t count) {
    next(count, [](std::size_t /*point*/) {});
}

void ShownPoints::append(std::size_t count, const Pose& scanInDrawn, DrawnPoints& drawn) {
    const Eigen::Affine3f motion(scanInDrawn.cast<float>());
    const ScanPoints& points = *m_scan->points;
    const PointPaint& paint = m_scan->look->paint;
    next(count, [&](std::size_t point) {
        drawn.points.push_back(motion * points.points[point]);
        drawn.colours.push_back(paint.colourOf(points, point));
    });
}

bool isShown(const SceneScan& scan) {
    return scan.visible && scan.points && scan.look && scan.look->shown > 0;
}

DrawnPointsPtr drawnPoints(const SceneScan& scan) {
    auto drawn = std::make_shared<DrawnPoints>();
    drawn->points.reserve(scan.look->shown);
    drawn->colours.reserve(scan.look->shown);
    ShownPoints(scan).append(scan.look->shown, Pose::Identity(), *drawn);
    return drawn;
}

}  // namespace leitstand
