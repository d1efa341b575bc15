#pragma once

#include <map>
#include <string>

#include "core/event/picture_samples.h"
#include "robots/hardware/robot_hardware.h"

namespace leitstand::simulation {

/// Imitates cameras whose driver hangs: each publishes its last picture again and again, under new stamps.
class FrozenPictures {
public:
    /// While @p frozen, replaces the picture in @p sample by the last one of its camera before that;
    /// otherwise remembers the picture. Leaves all other samples as they are, infrared pictures too.
    void pass(HardwareSample& sample, bool frozen);

private:
    std::map<std::string, PictureSample> m_last;  ///< by sensor
};

}  // namespace leitstand::simulation
