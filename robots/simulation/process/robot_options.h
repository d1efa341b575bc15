#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robots/simulation/process/choose_arena.h"

namespace CLI {
class App;
}

namespace leitstand::simulation {

/// What `leitstand-robot kurt3d` and `leitstand-robot crawler` are told.
struct RobotOptions {
    std::string kind;              ///< "kurt3d", "crawler"
    std::string arena = "yellow";  ///< a grade, or a file
    std::uint64_t seed = 1;
    BuildingOptions building;
    std::string file;  ///< of the robot, or a shipped one's name; empty: kind
    std::string name;  ///< empty: as its file says
    int domain = 0;
    std::vector<std::string> interfaces, peers;
    std::string keys;           ///< folder of its identity; empty: unsecured
    bool careless = false;      ///< without a watchdog, and anybody's
    bool tilting = false;       ///< Kurt3D carries the tilting scanner of 2004
    bool turningLaser = false;  ///< the Crawler's laser turns
};

/// `kurt3d`, `crawler`: drives a robot until it is interrupted. @p exitCode: 0 ok, 1 it failed.
void addRobots(CLI::App& app, int& exitCode);
/// `arena GRADE --seed N --out FILE`: writes a generated arena.
void addArena(CLI::App& app, int& exitCode);

}  // namespace leitstand::simulation
