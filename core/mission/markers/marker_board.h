#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/map_samples.h"

namespace leitstand {

/// What a robot draws on one topic.
struct MarkerBoard {
    static constexpr std::size_t MostMarkers = 2'000, MostPoints = 50'000;  ///< of a topic

    struct Drawn {
        Time received{};                       ///< station's clock
        Pose baseInOdom = Pose::Identity();    ///< of the robot then
        std::shared_ptr<const Marker> marker;  ///< never null; shared with earlier states
    };
    std::map<std::pair<std::string, std::int32_t>, Drawn> drawn;  ///< by Marker::space and id

    /// Adds, replaces and removes what @p sample says, received at @p received, when the robot was at @p
    /// baseInOdom. Markers whose lifetime is over then are removed; so are the oldest where there are too
    /// many.
    void take(const MarkersSample& sample, Time received, const Pose& baseInOdom = Pose::Identity());
};

[[nodiscard]] bool isBounded(const MarkerBoard& board);  ///< whether it has no more than it may

/// Whether all numbers of @p marker are such that it can be drawn: no place is farther away than 1000 km.
[[nodiscard]] bool isDrawable(const Marker& marker);

/// Whether @p one is no longer drawn at @p now.
[[nodiscard]] inline bool isOver(const MarkerBoard::Drawn& one, Time now) {
    return one.marker->lifetime.count() > 0 && now - one.received > one.marker->lifetime;
}

}  // namespace leitstand
