#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "core/robot/robot_description.h"
#include "robots/hardware/robot_hardware.h"
#include "robots/simulation/sensors/laser/spinning_lidar.h"
#include "robots/simulation/world/world.h"

namespace leitstand::simulation {

/// Which scanner Kurt3D has.
enum class ScannerMount { ScanDrive, Tilting };

/// Equipment of a simulated robot.
struct HardwareSettings {
    std::uint64_t seed = 1;                          ///< seed of its noise
    ScannerMount scanner = ScannerMount::ScanDrive;  ///< for Kurt3D
    bool turningLaser = false;  ///< for the Crawler: whether its laser turns and also gives 3D slices
    bool cameras = true;        ///< whether pictures are drawn; false makes tests quicker
    SpinningLidarSettings lidar = vlp16();  ///< for stock robots, but for its place
    bool lidarMountTold = true;             ///< for stock robots: whether tf tells where the lidar sits
    /// Called before each picture; empty: pictures are always drawn.
    std::function<bool(std::string_view sensor)> mayDraw = {};
};

/// Creates the sensors and motors of Kurt3D or the Crawler in a world. Frames, sensors and mountings are
/// those of the description (resources/robots). The owner of the world advances it; RobotHardware::take()
/// measures up to the world's present time.
[[nodiscard]] std::unique_ptr<RobotHardware> makeKurt3dHardware(World& world, int robot,
                                                                const RobotDescription& description,
                                                                const HardwareSettings& settings = {});
[[nodiscard]] std::unique_ptr<RobotHardware> makeCrawlerHardware(World& world, int robot,
                                                                 const RobotDescription& description,
                                                                 const HardwareSettings& settings = {});
/// As above, for a stock robot: a spinning lidar, a laser for all directions, and a camera that looks ahead,
/// if the description has streams for them.
[[nodiscard]] std::unique_ptr<RobotHardware> makeStockHardware(World& world, int robot,
                                                               const RobotDescription& description,
                                                               const HardwareSettings& settings = {});

}  // namespace leitstand::simulation
