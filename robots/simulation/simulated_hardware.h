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
    bool turningLaser = false;  ///< of the Crawler: its laser turns and gives 3D slices too
    bool cameras = true;        ///< false: no picture is drawn (quicker tests)
    std::function<bool(std::string_view sensor)> mayDraw = {};  ///< asked before each picture; empty: always
};

/// Creates the sensors and motors of Kurt3D or the Crawler in a world. Frames, sensors and mountings are
/// those of the description (resources/robots). The world's owner advances it; RobotHardware::take() measures
/// up to the world's present time.
[[nodiscard]] std::unique_ptr<RobotHardware> makeKurt3dHardware(World& world, int robot,
                                                                const RobotDescription& description,
                                                                const HardwareSettings& settings = {});
[[nodiscard]] std::unique_ptr<RobotHardware> makeCrawlerHardware(World& world, int robot,
                                                                 const RobotDescription& description,
                                                                 const HardwareSettings& settings = {});
/// The same for a stock robot: a spinning lidar, a laser all around, and a camera that looks ahead, as far as
/// the description has streams of them.
[[nodiscard]] std::unique_ptr<RobotHardware> makeStockHardware(World& world, int robot,
                                                               const RobotDescription& description,
                                                               const HardwareSettings& settings = {});

}  // namespace leitstand::simulation
