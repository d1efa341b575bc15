#include "robots/simulation/arena/building_generator.h"

#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "robots/simulation/arena/building/plan.h"

namespace leitstand::simulation {
namespace {

constexpr double LeastWidth = 28.0, LeastDepth = 20.0, Most = 90.0;  ///< [m]
constexpr int MostStoreys = 3;

void placeStarts(building::Plan& plan) {
    const Eigen::Vector2d corner = plan.ways.ring.min();
    const double x = building::Plan::rounded(corner.x() + 0.6);
    for (const auto& [robot, side] : {std::pair{"kurt3d", 0.35}, std::pair{"crawler", -0.35}}) {
        plan.arena.starts[robot] =
            poseFrom({x, building::Plan::rounded(corner.y() + side), 0.0}, 0.0, 0.0, 0.0);
    }
}

Result<void> check(const BuildingSettings& settings) {
    const bool fits = settings.width >= LeastWidth && settings.width <= Most &&
                      settings.depth >= LeastDepth && settings.depth <= Most;
    if (!fits) {
        return Error{fmt::format("size {}x{}: expected a building of {}x{} to {}x{} m", settings.width,
                                 settings.depth, LeastWidth, LeastDepth, Most, Most)};
    }
    if (settings.storeys < 1 || settings.storeys > MostStoreys)
        return Error{fmt::format("storeys {}: expected 1 to {}", settings.storeys, MostStoreys)};
    return {};
}

}  // namespace

Result<Building> generateBuilding(const BuildingSettings& settings, std::uint64_t seed) {
    if (const auto right = check(settings); !right) return right.error();
    building::Plan plan(settings, seed);
    placeStarts(plan);
    layFloors(plan);
    for (int storey = 0; storey < settings.storeys; ++storey) {
        if (storey + 1 < settings.storeys) buildShaft(plan, storey);
        buildOuterStrips(plan, storey);
        buildBlocks(plan, storey);
        furnishCorridors(plan, storey);
        if (plan.troubled()) makeTrouble(plan, storey);
    }
    layVictims(plan);
    return Building{std::move(plan.arena), std::move(plan.ways)};
}

Result<Eigen::Vector2d> buildingSizeFrom(const std::string& text) {
    static const std::regex size(R"((\d{1,6}(?:\.\d{1,3})?)x(\d{1,6}(?:\.\d{1,3})?))");
    std::smatch found;
    if (!std::regex_match(text, found, size))
        return Error{fmt::format("size \"{}\": expected WIDTHxDEPTH in metres, as 60x40", text)};
    return Eigen::Vector2d(std::stod(found[1].str()), std::stod(found[2].str()));
}

}  // namespace leitstand::simulation
