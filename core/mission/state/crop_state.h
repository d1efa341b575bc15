#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/base/pose.h"
#include "core/base/time.h"
#include "core/event/map_samples.h"

namespace leitstand {

/// A corner of the area that belongs to the map. It moves with the key scan that was nearest when it was
/// drawn.
struct AreaCorner {
    Eigen::Vector2d drawn = Eigen::Vector2d::Zero();  ///< in the map frame of that time [m]
    std::uint64_t scan = 0;                           ///< id of that scan; 0: there was none
    Pose scanInMap = Pose::Identity();                ///< at that time
};

/// The area that belongs to the map, as the newest decision that is not undone has it.
struct CropState {
    std::uint64_t sequence = 0;       ///< of that decision
    Time received{};                  ///< station's clock
    MapCropSample sample;             ///< as published: areaInMap() returns where it is now
    std::vector<AreaCorner> corners;  ///< of its polygon
};

}  // namespace leitstand
