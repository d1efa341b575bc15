#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/map_samples.h"

namespace leitstand {

/// A corner of the map's area. It moves with the key scan that was nearest when the corner was drawn.
struct AreaCorner {
    Eigen::Vector2d drawn = Eigen::Vector2d::Zero();  ///< in the map as it was when it was drawn [m]
    std::uint64_t scan = 0;                           ///< id of that scan; 0: there was none
    Pose scanInMap = Pose::Identity();                ///< pose of that scan when the corner was drawn
};

/// The area that belongs to the map, from the newest decision that is not undone.
struct CropState {
    std::uint64_t sequence = 0;       ///< sequence of that decision
    Time received{};                  ///< when it was received, station's clock
    MapCropSample sample;             ///< as published; areaInMap() returns where it is now
    std::vector<AreaCorner> corners;  ///< corners of its polygon
};

}  // namespace leitstand
