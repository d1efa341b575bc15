#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

#include "widgets/map_view/map_view.h"
#include "widgets/map_view/scene/scene_content.h"

namespace leitstand {

/// A measurement between two points of a map. Each end moves with the scan that holds its point.
class MapRuler {
public:
    /// Sets the next end of the measurement to @p picked, a point of @p content: the first end, then the
    /// second. A third pick begins a new measurement.
    void pick(const PickedPoint& picked, const SceneContent& content);
    void clear();
    [[nodiscard]] bool begun() const { return m_from.has_value(); }
    /// Position of an end in @p content, in the map's frame [m]; empty: not picked.
    [[nodiscard]] std::optional<Eigen::Vector3d> from(const SceneContent& content) const;
    [[nodiscard]] std::optional<Eigen::Vector3d> to(const SceneContent& content) const;
    [[nodiscard]] std::optional<Measurement> measurement(const SceneContent& content) const;

private:
    struct End {
        /// Index of the end's scan in SceneContent::scans; used when scans have no id.
        std::size_t index = 0;
        std::uint64_t id = 0;                              ///< SceneScan::id of the end's scan
        Eigen::Vector3d inScan = Eigen::Vector3d::Zero();  ///< position in the scan's frame [m]
        /// Position in the map when it was picked; used when its scan is gone [m].
        Eigen::Vector3d inMap = Eigen::Vector3d::Zero();
    };
    [[nodiscard]] static std::optional<Eigen::Vector3d> placeOf(const std::optional<End>& end,
                                                                const SceneContent& content);

    std::optional<End> m_from, m_to;
};

}  // namespace leitstand
