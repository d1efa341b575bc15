#include "core/mission/coverage/coverage_map.h"

#include <algorithm>
#include <cmath>

namespace leitstand {

CoverageMap::CoverageMap(SearchGround ground, const CoverageSettings& settings)
    : m_ground(std::move(ground)), m_settings(settings) {
    for (Layer& layer : m_layers) layer.assign(m_ground.size(), 0);
}

/// The place that a sensor looks from, and the box that it can see at most.
struct CoverageMap::Reach {
    Eigen::Vector3d from = Eigen::Vector3d::Zero();                                 ///< [m]
    double range = 0.0;                                                             ///< [m]
    Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();  ///< x, y in the map [m]

    /// A sensor that sees in all directions, up to @p farthest [m].
    Reach(const Eigen::Vector3d& place, double farthest)
        : from(place),
          range(farthest),
          low(place.head<2>() - Eigen::Vector2d::Constant(farthest)),
          high(place.head<2>() + Eigen::Vector2d::Constant(farthest)) {}
    /// A camera that sees within @p halfAngle [rad] of its axis, up to @p farthest [m].
    Reach(const Pose& cameraInMap, double halfAngle, double farthest)
        : from(cameraInMap.translation()), range(farthest) {
        const Eigen::Vector3d axis = cameraInMap.linear().col(2);
        const auto along = [&](double share) {  // share: cosine to the camera's axis
            const double off = std::acos(std::clamp(share, -1.0, 1.0));
            return farthest * std::max(0.0, std::cos(std::clamp(off - halfAngle, 0.0, degrees(90))));
        };
        low = from.head<2>() - Eigen::Vector2d(along(-axis.x()), along(-axis.y()));
        high = from.head<2>() + Eigen::Vector2d(along(axis.x()), along(axis.y()));
    }
};

/// Marks the floor within @p reach that nothing hides. @p spans returns how many times the required points or
/// pixels a body at a place in the map spans.
template <class Spans>
void CoverageMap::sweep(SearchSensor sensor, const Reach& reach, Spans spans) {
    const Eigen::Vector3d& from = reach.from;
    const double range = reach.range;
    if (m_ground.size() == 0 || !from.allFinite() || !(range > 0.0)) return;
    Layer& layer = m_layers[static_cast<std::size_t>(sensor)];
    const Eigen::Vector2d& origin = m_ground.origin();
    const auto first = [&](int axis) {
        return std::floor(std::clamp((reach.low[axis] - origin[axis]) / m_ground.cell(), 0.0, 1e6));
    };
    const auto last = [&](int axis, int count) {
        return std::min(count - 1.0, std::floor((reach.high[axis] - origin[axis]) / m_ground.cell()));
    };
    for (double row = first(1); row <= last(1, m_ground.rows()); ++row) {
        for (double column = first(0); column <= last(0, m_ground.columns()); ++column) {
            const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(m_ground.columns()) +
                              static_cast<std::size_t>(column);
            if (!m_ground.isFloor(cell) || layer[cell] == 255) continue;
            Eigen::Vector3d body;
            body << m_ground.middleOf(cell),
                static_cast<double>(m_ground.height(cell)) + m_settings.bodyMiddle;
            if ((body - from).squaredNorm() > range * range) continue;
            const double times = spans(body);
            if (!(times >= 1.0)) continue;
            const double well = std::min(1.0, (times - 1.0) / std::max(1e-6, m_settings.sure - 1.0));
            const auto value = static_cast<std::uint8_t>(1 + std::lround(254.0 * well));
            // The test for occlusion is the slow part, so it comes last.
            if (value <= layer[cell] || m_ground.hides(from, body)) continue;
            layer[cell] = value;
        }
    }
}

void CoverageMap::look(const SearchView& view, const Pose& scanInMap) {
    const Pose cameraInMap = scanInMap * view.cameraInScan, mapInCamera = cameraInMap.inverse();
    const Eigen::Vector3d from = cameraInMap.translation();
    const Reach reach(cameraInMap, view.field.halfAngle(), view.range(m_settings));
    const double needed =
        view.sensor == SearchSensor::Infrared ? m_settings.infraredPixels : m_settings.cameraPixels;
    sweep(view.sensor, reach, [&](const Eigen::Vector3d& body) {
        if (!view.field.holds(mapInCamera * body)) return 0.0;
        const double away = std::max(0.05, (body - from).norm());
        return m_settings.bodySide / away * view.field.pixelsPerRadian / std::max(1e-6, needed);
    });
}

void CoverageMap::scan(const ShotDensity& shots, const Pose& scanInMap) {
    const Eigen::Vector3d from = scanInMap.translation();
    const Eigen::Matrix3d mapInScan = scanInMap.linear().transpose();
    sweep(SearchSensor::Scanner, {from, m_settings.scannerReach}, [&](const Eigen::Vector3d& body) {
        const Eigen::Vector3d away = body - from;
        const double points =
            shots.about(mapInScan * away) * m_settings.bodyArea / std::max(0.01, away.squaredNorm());
        return points / std::max(1e-6, m_settings.scannerPoints);
    });
}

float CoverageMap::quality(SearchSensor sensor, std::size_t cell) const {
    const std::uint8_t value = of(sensor)[cell];
    return value == 0 ? -1.0F : static_cast<float>(value - 1) / 254.0F;
}

float CoverageMap::cleared(const Eigen::Vector2d& place) const {
    const auto found = m_ground.cellAt(place);
    if (found < 0) return -1.0F;
    const auto cell = static_cast<std::size_t>(found);
    const float camera = quality(SearchSensor::Camera, cell),
                infrared = quality(SearchSensor::Infrared, cell);
    if (camera < 0.0F && infrared < 0.0F) return -1.0F;
    return 1.0F - (1.0F - std::max(0.0F, camera)) * (1.0F - std::max(0.0F, infrared));
}

double CoverageMap::seenArea(SearchSensor sensor) const {
    std::size_t cells = 0;
    for (std::size_t cell = 0; cell < m_ground.size(); ++cell)
        cells += m_ground.isReachable(cell) && seen(sensor, cell) ? 1 : 0;
    return static_cast<double>(cells) * m_ground.cell() * m_ground.cell();
}

}  // namespace leitstand
