#include "widgets/map_view/picking.h"

#include <array>
#include <cmath>
#include <limits>

#include "widgets/map_view/camera/map_camera.h"
#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/scene_content.h"
#include "widgets/map_view/scene/scene_statistics.h"

namespace leitstand {
namespace {

constexpr auto NearestDepth = static_cast<float>(MapProjection::NearestDepth);
constexpr std::array<double, 3> Rings = {2.0, 4.0, 8.0};  ///< [px]

/// The frontmost point of a ring around the cursor.
struct Candidate {
    float depth = std::numeric_limits<float>::max();
    std::size_t scan = 0, point = 0;
};
using Candidates = std::array<Candidate, Rings.size()>;

/// A scan's points in the camera's axes, moved so that the ray through the cursor is the middle.
class CursorFrame {
public:
    CursorFrame(const Pose& poseInMap, const MapProjection& projection, const QPointF& position) {
        const MapCamera& camera = projection.camera();
        Eigen::Matrix3d axes;
        axes << camera.right().transpose(), camera.up().transpose(), camera.forward().transpose();
        m_rotation = (axes * poseInMap.linear()).cast<float>();
        m_translation = (axes * (poseInMap.translation() - camera.eye())).cast<float>();
        // Across = offset + slope * depth; one of the two is zero, depending on the projection.
        const double unit = projection.metresPerPixel(1.0);
        const Eigen::Vector2d middle(position.x() - projection.size().width() / 2.0,
                                     projection.size().height() / 2.0 - position.y());
        m_parallel = camera.parallel;
        m_metresPerPixel = static_cast<float>(unit);
        m_middle = (unit * middle).cast<float>();
    }

    /// Computes the squared distance from the cursor [px^2] and the depth [m] of a point of the scan.
    void look(const Eigen::Vector3f& point, float& squaredPixels, float& depth) const {
        const Eigen::Vector3f seen = m_rotation * point + m_translation;
        depth = seen.z();
        const float scale = m_parallel ? 1.0F : depth;
        const Eigen::Vector2f away = seen.head<2>() - scale * m_middle;
        const float pixel = scale * m_metresPerPixel;
        squaredPixels = away.squaredNorm() / (pixel * pixel);
    }

    /// Whether a ball around @p centre may hold points within the outermost ring.
    [[nodiscard]] bool mayReach(const Eigen::Vector3f& centre, float radius) const {
        constexpr auto Reach = static_cast<float>(Rings.back());
        const Eigen::Vector3f seen = m_rotation * centre + m_translation;
        if (seen.z() + radius < NearestDepth) return false;
        // Across the ray, not across the screen: the ball's outline is nowhere wider than this.
        const float scale = m_parallel ? 1.0F : seen.z();
        const float slant = m_parallel ? 1.0F : std::sqrt(1.0F + m_middle.squaredNorm());
        const float away = (seen.head<2>() - scale * m_middle).norm();
        const float farthest = m_parallel ? 1.0F : seen.z() + radius;
        return away <= radius * slant + Reach * m_metresPerPixel * farthest;
    }

private:
    Eigen::Matrix3f m_rotation;
    Eigen::Vector3f m_translation;
    Eigen::Vector2f m_middle;
    float m_metresPerPixel = 1.0F;
    bool m_parallel = false;
};

/// Whether a point of @p scan is drawn at all.
bool isDrawn(const SceneScan& scan, std::size_t point, const MapViewSettings& settings) {
    const Eigen::Vector3d inScan = scan.points->points[point].cast<double>();
    return isShown((scan.poseInMap * inScan).z(), scan.points->labels[point], settings);
}

/// Keeps point @p point of scan @p index in @p candidates if it is nearer than those found so far.
void consider(const SceneContent& content, std::size_t index, std::size_t point, const CursorFrame& frame,
              Candidates& candidates) {
    constexpr auto Reach = static_cast<float>(Rings.back() * Rings.back());
    const SceneScan& scan = content.scans[index];
    float squaredPixels = 0.0F, depth = 0.0F;
    frame.look(scan.points->points[point], squaredPixels, depth);
    if (!(squaredPixels <= Reach) || depth < NearestDepth) return;
    std::size_t ring = 0;
    while (squaredPixels > static_cast<float>(Rings[ring] * Rings[ring])) ++ring;
    const bool better = depth < candidates[ring].depth;
    if (better && isDrawn(scan, point, content.settings)) candidates[ring] = {depth, index, point};
}

void search(const SceneContent& content, std::size_t index, const CursorFrame& frame,
            Candidates& candidates) {
    const ScanPoints& points = *content.scans[index].points;
    for (const PointCell& cell : points.cells) {
        if (!frame.mayReach(cell.centre, cell.radius)) continue;
        for (std::size_t run = cell.first; run < cell.end; ++run) {
            for (std::size_t point = points.runs[run].first; point < points.runs[run].end; ++point) {
                consider(content, index, point, frame, candidates);
            }
        }
    }
}

}  // namespace

std::optional<PickedPoint> pickPoint(const SceneContent& content, const MapProjection& projection,
                                     const QPointF& position) {
    Candidates candidates;
    for (std::size_t i = 0; i < content.scans.size(); ++i) {
        const SceneScan& scan = content.scans[i];
        if (!scan.visible || !scan.points || scan.points->points.empty()) continue;
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
