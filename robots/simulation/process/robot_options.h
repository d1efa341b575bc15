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

constexpr int TruthAbove = 100;               ///< the truth's domain is so much above the robot's
constexpr int LastDomain = 232 - TruthAbove;  ///< of a simulated robot

/// Options of `leitstand-robot kurt3d` and `leitstand-robot crawler`.
struct RobotOptions {
    std::string kind;              ///< "kurt3d", "crawler"
    std::string arena = "yellow";  ///< a grade, or a file
    std::uint64_t seed = 1;
    BuildingOptions building;
    std::string file;  ///< robot file, or name of a shipped one; empty: kind
    std::string name;  ///< empty: as in its file
    DomainOptions network;
    const StockProfile* stock = nullptr;  ///< whose robot it is; null: ours
    std::string nameSpace;                ///< of a stock robot
    bool careless = false;                ///< has no watchdog and obeys anybody
    bool tilting = false;                 ///< Kurt3D carries the tilting scanner of 2004
    bool turningLaser = false;            ///< the Crawler's laser turns
};

/// Adds the commands `kurt3d` and `crawler`, which drive a robot until they are interrupted. @p exitCode: 0
/// ok, 1 failed.
void addRobots(CLI::App& app, int& exitCode);
/// Adds the command `stock PROFILE`, which drives a robot as its maker ships it.
void addStock(CLI::App& app, int& exitCode);
/// Adds the command `arena GRADE --seed N --out FILE`, which writes a generated arena.
void addArena(CLI::App& app, int& exitCode);

}  // namespace leitstand::simulation
