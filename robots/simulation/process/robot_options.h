#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/settings/domain_settings.h"
#include "robots/simulation/process/choose_arena.h"

namespace CLI {
class App;
}

namespace leitstand::simulation {

struct StockProfile;

constexpr int TruthAbove = 100;  ///< number of the truth's domain minus that of the robot's domain
constexpr int LastDomain = 232 - TruthAbove;  ///< highest domain of a simulated robot

/// Options of `leitstand-robot kurt3d` and `leitstand-robot crawler`.
struct RobotOptions {
    std::string kind;              ///< "kurt3d", "crawler"
    std::string arena = "yellow";  ///< a grade or a file
    std::uint64_t seed = 1;
    BuildingOptions building;
    std::string file;  ///< a robot's file, or the name of a shipped one; empty: that of `kind`
    std::string name;  ///< name of the robot; empty: as in its file
    DomainOptions network;
    const StockProfile* stock = nullptr;  ///< profile of a stock robot; null: one of our robots
    std::string nameSpace;                ///< namespace of a stock robot
    bool careless = false;                ///< whether it has no watchdog and obeys anybody
    bool tilting = false;                 ///< whether Kurt3D has the tilting scanner of 2004
    bool turningLaser = false;            ///< whether the Crawler's laser turns
};

/// Adds the commands `kurt3d` and `crawler`, which run a robot until they are interrupted. @p exitCode: 0
/// success, 1 failure.
void addRobots(CLI::App& app, int& exitCode);
/// Adds the command `stock PROFILE`, which runs a robot as its manufacturer delivers it.
void addStock(CLI::App& app, int& exitCode);
/// Adds the command `arena GRADE --seed N --out FILE`, which writes a generated arena.
void addArena(CLI::App& app, int& exitCode);

}  // namespace leitstand::simulation
