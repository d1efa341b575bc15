#include "widgets/map_view/picking.h"

#include <array>
#include <limits>

#include "widgets/map_view/map_camera.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/scene_content.h"
#include "widgets/map_view/scene/scene_statistics.h"

namespace leitstand {
namespace {

constexpr std::array<double, 3> Rings = {2.0, 4.0, 8.0};  ///< [px]

/// The frontmost point of a ring around the cursor.
struct Candidate {
    float depth = std::numeric_limits<float>::max();
    std::size_t scan = 0, point = 0;
};
using Candidates = std::array<Candidate, Rings.size()>;

/// Whether the box around a scan's points reaches the cursor.
bool mayReach(const SceneScan& scan, const MapProjection& projection, const QPointF& position) {
    QRectF drawn;
    for (int corner = 0; corner < 8; ++corner) {
        const auto type = static_cast<Eigen::AlignedBox3f::CornerType>(corner);
        const auto seen =
            projection.project(scan.poseInMap * scan.points->bounds.corner(type).cast<double>());
        if (!seen) return true;  // reaches behind the eye: its outline means nothing
        drawn |= QRectF(seen->position, QSizeF(1e-3, 1e-3));
    }
    const double reach = Rings.back();
    return drawn.adjusted(-reach, -reach, reach, reach).contains(position);
}

/// A scan's points in the camera's axes, moved so that the ray through the cursor is the middle.
class CursorFrame {
public:
    CursorFrame(const Pose& poseInMap, const MapProjection& projection, const QPointF& position) {
        const MapCamera& camera = projection.camera();
        Eigen::Matrix3d axes;
        axes << camera.right().transpose(), camera.up().transpose(), camera.forward().transpose();
        m_rotation = (axes * poseInMap.linear()).cast<float>();
        m_translation = (axes * (poseInMap.translation() - camera.eye())).cast<float>();
        // Across = offset + slope * depth: one of them is nought, depending on the projection.
        const double unit = projection.metresPerPixel(1.0);
        const Eigen::Vector2d middle(position.x() - projection.size().width() / 2.0,
                                     projection.size().height() / 2.0 - position.y());
        m_parallel = camera.parallel;
        m_metresPerPixel = static_cast<float>(unit);
        m_middle = (unit * middle).cast<float>();
    }

    /// Distance from the cursor [px], squared, and depth [m] of a point of the scan.
    void look(const Eigen::Vector3f& point, float& squaredPixels, float& depth) const {
        const Eigen::Vector3f seen = m_rotation * point + m_translation;
        depth = seen.z();
        const float scale = m_parallel ? 1.0F : depth;
        const Eigen::Vector2f away = seen.head<2>() - scale * m_middle;
        const float pixel = scale * m_metresPerPixel;
        squaredPixels = away.squaredNorm() / (pixel * pixel);
    }

private:
    Eigen::Matrix3f m_rotation;
    Eigen::Vector3f m_translation;
    Eigen::Vector2f m_middle;
    float m_metresPerPixel = 1.0F;
    bool m_parallel = false;
};

void search(const SceneContent& content, std::size_t index, const CursorFrame& frame,
            Candidates& candidates) {
    constexpr auto Nearest = static_cast<float>(MapProjection::NearestDepth);
    constexpr auto Reach = static_cast<float>(Rings.back() * Rings.back());
    const SceneScan& scan = content.scans[index];
    for (std::size_t i = 0; i < scan.points->points.size(); ++i) {
        const Eigen::Vector3f& point = scan.points->points[i];
        float squaredPixels = 0.0F, depth = 0.0F;
        frame.look(point, squaredPixels, depth);
        if (!(squaredPixels <= Reach) || depth < Nearest) continue;
        const double height = (scan.poseInMap * point.cast<double>()).z();
        if (!isShown(height, scan.points->labels[i], content.settings)) continue;
        std::size_t ring = 0;
        while (squaredPixels > static_cast<float>(Rings[ring] * Rings[ring])) ++ring;
        if (depth < candidates[ring].depth) candidates[ring] = {depth, index, i};
    }
}

}  // namespace

std::optional<PickedPoint> pickPoint(const SceneContent& content, const MapProjection& projection,
                                     const QPointF& position) {
    Candidates candidates;
    for (std::size_t i = 0; i < content.scans.size(); ++i) {
        const SceneScan& scan = content.scans[i];
        if (!scan.visible || !scan.points || scan.points->points.empty()) continue;
        if (!mayReach(scan, projection, position)) continue;
        search(content, i, CursorFrame(scan.poseInMap, projection, position), candidates);
    }
    for (const Candidate& found : candidates) {
        if (found.depth == std::numeric_limits<float>::max()) continue;
        const SceneScan& scan = content.scans[found.scan];
        return PickedPoint{scan.poseInMap * scan.points->points[found.point].cast<double>(),
                           static_cast<int>(found.scan), scan.points->labels[found.point]};
    }
    return std::nullopt;
}

}  // namespace leitstand
