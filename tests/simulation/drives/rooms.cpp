#include "tests/simulation/drives/rooms.h"

#include <cmath>
#include <string>

namespace leitstand::simulation::test {
namespace {

constexpr double Height = 1.2;  ///< of walls [m]

}  // namespace

Element wall(const std::string& name, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    Element wall = elementOf(ElementKind::Wall);
    wall.name = name;
    const Eigen::Vector2d along = b - a, middle = 0.5 * (a + b);
    wall.size = {along.norm(), 0.05, Height};
    wall.pose = poseFrom({middle.x(), middle.y(), 0.0}, 0.0, 0.0, std::atan2(along.y(), along.x()));
    return wall;
}

Arena room(double x, double y) {
    Arena arena;
    arena.name = "room";
    arena.from = {0.0, 0.0};
    arena.to = {x, y};
    Element floor = elementOf(ElementKind::Floor);
    floor.name = "floor";
    floor.size = {x, y, 0.1};
    floor.pose = poseFrom({x / 2, y / 2, 0.0}, 0.0, 0.0, 0.0);
    arena.elements = {floor, wall("south", {0, 0}, {x, 0}), wall("east", {x, 0}, {x, y}),
                      wall("north", {x, y}, {0, y}), wall("west", {0, y}, {0, 0})};
    arena.starts["kurt3d"] = arena.starts["crawler"] = poseFrom({0.8, y / 2, 0.0}, 0.0, 0.0, 0.0);
    return arena;
}

Element warmVictim(const Eigen::Vector2d& place, double yaw) {
    Element victim = elementOf(ElementKind::Victim);
    victim.name = "victim";
    victim.size = {1.0, 0.3, 0.2};
    victim.pose = poseFrom({place.x(), place.y(), 0.0}, 0.0, 0.0, yaw);
    victim.victim->temperature = 35.0;
    victim.victim->situation = Situation::Surface;
    return victim;
}

Element rampAt(double x, double length, double y, double angle) {
    Element ramp = elementOf(ElementKind::Ramp);
    ramp.name = "ramp";
    ramp.size = {length, y, length * std::tan(angle)};
    ramp.pose = poseFrom({x + length / 2, y / 2, 0.0}, 0.0, 0.0, 0.0);
    return ramp;
}

}  // namespace leitstand::simulation::test
