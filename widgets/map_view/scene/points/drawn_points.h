#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// Points as they go to OpenGL, in the order in which they are drawn.
struct DrawnPoints {
    std::vector<Eigen::Vector3f> points;  ///< [m]
    std::vector<Rgba> colours;            ///< one per point

    [[nodiscard]] std::size_t size() const { return points.size(); }
};
using DrawnPointsPtr = std::shared_ptr<const DrawnPoints>;

/// Goes through the points of a scan that are drawn, in their random order.
class ShownPoints {
public:
    /// @p scan, which outlives it, is made ready (isShown()).
    explicit ShownPoints(const SceneScan& scan) : m_scan(&scan) {}

    /// Passes by the next @p count of them.
    void skip(std::size_t count);
    /// Adds the next @p count of them to @p drawn, moved by @p scanInDrawn.
    void append(std::size_t count, const Pose& scanInDrawn, DrawnPoints& drawn);

private:
    template <typename Take>
    void next(std::size_t count, Take take);

    const SceneScan* m_scan;
    std::size_t m_at = 0;  ///< in the scan's order
};

/// Whether points of @p scan are to be seen.
[[nodiscard]] bool isShown(const SceneScan& scan);

/// All points of @p scan that are drawn, in its frame. It is made ready.
[[nodiscard]] DrawnPointsPtr drawnPoints(const SceneScan& scan);

}  // namespace leitstand
