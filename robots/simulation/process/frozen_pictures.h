#pragma once

#include <map>
#include <string>

#include "core/event/picture_samples.h"
#include "robots/hardware/robot_hardware.h"

namespace leitstand::simulation {

/// Simulates cameras whose driver hangs: each publishes its last picture again and again with new stamps.
class FrozenPictures {
public:
    /// While @p frozen, replaces the picture in @p sample by the last picture of its camera before that.
    /// Otherwise remembers the picture. All other samples are not changed, including infrared pictures.
    void pass(HardwareSample& sample, bool frozen);

private:
    std::map<std::string, PictureSample> m_last;  ///< by sensor
};

}  // namespace leitstand::simulation
