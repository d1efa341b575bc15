#pragma once

#include <map>
#include <string>

#include "core/event/picture_samples.h"
#include "robots/hardware/robot_hardware.h"

namespace leitstand::simulation {

/// Imitates cameras whose driver hangs: each publishes its last picture again and again, under new stamps.
class FrozenPictures {
public:
    /// Replaces the picture in @p sample by its camera's last one while @p frozen; otherwise keeps it as the
    /// last one. Leaves samples other than camera pictures as they are, infrared pictures too.
    void pass(HardwareSample& sample, bool frozen);

private:
    std::map<std::string, PictureSample> m_last;  ///< by sensor
};

}  // namespace leitstand::simulation
