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

/// What of the floor was searched, and with what.
class CoverageMap {
public:
    explicit CoverageMap(SearchGround ground, const CoverageSettings& settings = {});

    /// A camera looked from there.
    void look(const SearchView& view, const Pose& scanInMap);
    /// A scan was taken there.
    void scan(const ShotDensity& shots, const Pose& scanInMap);

    [[nodiscard]] const SearchGround& ground() const { return m_ground; }
    [[nodiscard]] const CoverageSettings& settings() const { return m_settings; }
    [[nodiscard]] bool seen(SearchSensor sensor, std::size_t cell) const { return of(sensor)[cell] != 0; }
    /// How well: 0 where a body just spans enough, 1 where it spans CoverageSettings::sure times as much;
    /// below 0 where it was not seen.
    [[nodiscard]] float quality(SearchSensor sensor, std::size_t cell) const;
    /// How surely a camera would have shown a victim at @p place [m], 0 to 1; below 0 where none looked.
    [[nodiscard]] float cleared(const Eigen::Vector2d& place) const;
    [[nodiscard]] double seenArea(SearchSensor sensor) const;  ///< of the floor that can be reached [m2]

private:
    using Layer = std::vector<std::uint8_t>;  ///< 0: not seen, 1 to 255: how well
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

/// What was searched of a storey.
struct StoreyCoverage {
    StoreyShare storey;
    CoverageMapPtr map;  ///< never null
};

}  // namespace leitstand
