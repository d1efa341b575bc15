#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/robot/robot_description.h"
#include "robots/hardware/robot_hardware.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// Which scanner Kurt3D carries.
enum class ScannerMount { ScanDrive, Tilting };

/// What a simulated robot is fitted with.
struct HardwareSettings {
    std::uint64_t seed = 1;                          ///< of its noise
    ScannerMount scanner = ScannerMount::ScanDrive;  ///< of Kurt3D
    bool turningLaser = false;                       ///< of the Crawler: its laser gives 3D slices too
    bool cameras = true;                             ///< off: nothing is drawn (quicker tests)
    std::function<bool(std::string_view sensor)> mayDraw = {};  ///< asked before each picture; none: always
};

/// The sensors and motors of Kurt3D or the Crawler in a world. Frames, sensors and mountings as in the
/// description (resources/robots). The world is moved on by its owner; take() measures up to its present.
[[nodiscard]] std::unique_ptr<RobotHardware> makeKurt3dHardware(World& world, int robot,
                                                                const RobotDescription& description,
                                                                const HardwareSettings& settings = {});
[[nodiscard]] std::unique_ptr<RobotHardware> makeCrawlerHardware(World& world, int robot,
                                                                 const RobotDescription& description,
                                                                 const HardwareSettings& settings = {});

}  // namespace leitstand::simulation
