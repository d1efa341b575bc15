#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/mission/coverage/search_ground.h"
#include "core/mission/coverage/search_view.h"
#include "core/mission/coverage/shot_density.h"

namespace leitstand {

/// Which floor each kind of sensor has searched, and how well.
class CoverageMap {
public:
    explicit CoverageMap(SearchGround ground, const CoverageSettings& settings = {});

    /// Marks the floor that a camera saw in @p view. @p scanInMap: pose of the view's key scan.
    void look(const SearchView& view, const Pose& scanInMap);
    /// Marks the floor that a scan at @p scanInMap saw. How well depends on the density of its @p shots.
    void scan(const ShotDensity& shots, const Pose& scanInMap);

    [[nodiscard]] const SearchGround& ground() const { return m_ground; }
    [[nodiscard]] const CoverageSettings& settings() const { return m_settings; }
    [[nodiscard]] bool seen(SearchSensor sensor, std::size_t cell) const { return of(sensor)[cell] != 0; }
    /// Returns how well a cell was seen. 0: a lying body would show just enough points or pixels. 1: it would
    /// show CoverageSettings::sure times as many. Below 0: not seen.
    [[nodiscard]] float quality(SearchSensor sensor, std::size_t cell) const;
    /// Returns how surely a camera (or infrared camera) would have shown a victim at @p place [m], 0 to 1.
    /// Below 0: no camera looked there.
    [[nodiscard]] float cleared(const Eigen::Vector2d& place) const;
    /// Area of reachable floor that @p sensor saw [m2].
    [[nodiscard]] double seenArea(SearchSensor sensor) const;

private:
    using Layer = std::vector<std::uint8_t>;  ///< how well each cell was seen, 1 to 255; 0: not seen
    [[nodiscard]] const Layer& of(SearchSensor sensor) const {
        return m_layers[static_cast<std::size_t>(sensor)];
    }
    struct Reach;
    template <class Spans>
    void sweep(SearchSensor sensor, const Reach& reach, Spans spans);

    SearchGround m_ground;
    CoverageSettings m_settings;
    std::array<Layer, SearchSensors.size()> m_layers;
};
using CoverageMapPtr = std::shared_ptr<const CoverageMap>;

/// What was searched on one storey.
struct StoreyCoverage {
    StoreyShare storey;
    CoverageMapPtr map;  ///< never null
};

}  // namespace leitstand
