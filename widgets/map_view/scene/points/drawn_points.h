#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// Points as passed to OpenGL, in drawing order.
struct DrawnPoints {
    std::vector<Eigen::Vector3f> points;  ///< [m]
    std::vector<Rgba> colours;            ///< one per point

    [[nodiscard]] std::size_t size() const { return points.size(); }
};
using DrawnPointsPtr = std::shared_ptr<const DrawnPoints>;

/// Iterates over the drawn points of a scan, in their random order.
class ShownPoints {
public:
    /// @p scan must be prepared (isShown()) and outlive this object.
    explicit ShownPoints(const SceneScan& scan) : m_scan(&scan) {}

    /// Skips the next @p count points.
    void skip(std::size_t count);
    /// Adds the next @p count points to @p drawn, transformed by @p scanInDrawn.
    void append(std::size_t count, const Pose& scanInDrawn, DrawnPoints& drawn);

private:
    template <typename Take>
    void next(std::size_t count, Take take);

    const SceneScan* m_scan;
    std::size_t m_at = 0;  ///< index in ScanPoints::order
};

/// Whether @p scan is visible, prepared, and has points to draw.
[[nodiscard]] bool isShown(const SceneScan& scan);

/// Returns all drawn points of @p scan, in its frame. The scan must be prepared.
[[nodiscard]] DrawnPointsPtr drawnPoints(const SceneScan& scan);

}  // namespace leitstand
