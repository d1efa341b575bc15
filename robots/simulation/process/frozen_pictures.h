#pragma once

#include <map>
#include <string>

#include "core/event/picture_samples.h"
#include "robots/hardware/robot_hardware.h"

namespace leitstand::simulation {

/// Cameras whose driver hangs, as they do: each says its last picture again and again, under new stamps.
class FrozenPictures {
public:
    /// Puts the last picture of its camera into @p sample while they are @p frozen, and else keeps it as
    /// that. Passes by what is no camera's picture; infrared is none.
    void pass(HardwareSample& sample, bool frozen);

private:
    std::map<std::string, PictureSample> m_last;  ///< by sensor
};

}  // namespace leitstand::simulation
