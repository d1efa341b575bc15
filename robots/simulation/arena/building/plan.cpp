#include "robots/simulation/arena/building/plan.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace leitstand::simulation::building {

Eigen::Vector2d Spot::inArena(double x, double y) const {
    switch (quarter & 3) {
        case 0:
            return {at.x() + x, at.y() + y};
        case 1:
            return {at.x() - y, at.y() + x};
        case 2:
            return {at.x() - x, at.y() - y};
        default:
            return {at.x() + y, at.y() - x};
    }
}

Plan::Plan(const BuildingSettings& given, std::uint64_t seed)
    : settings(given), random(seed * 0x9E3779B97F4A7C15ULL + 0xB11D0000ULL), m_roomSeed(random.next()) {
    arena.name = fmt::format("building {}", seed);
    const BuildingSettings usual;
    if (given.width != usual.width || given.depth != usual.depth)
        arena.name += fmt::format(" {}x{}", given.width, given.depth);
    if (given.storeys != usual.storeys) arena.name += fmt::format(" storeys {}", given.storeys);
    if (given.twins) arena.name += " twins";
    if (given.smooth) arena.name += " smooth";
    if (!given.troubles) arena.name += " calm";
    arena.grade = Grade::Building;
    arena.seed = seed;
    arena.to = {given.width, given.depth};
    arena.light = length(random, 0.55, 0.9);
    // Except for twins, the depth of rooms differs from building to building.
    roomDepth = given.twins ? 4.0 : length(random, 3.7, 4.3);
    // A file holds a limited number of elements, so large buildings have larger rooms.
    roomLength = 5.4 * std::max(1.0, (given.width + given.depth) * given.storeys / 200.0);
    const double inset = roomDepth + Corridor / 2;
    ways.ring = Eigen::AlignedBox2d(Eigen::Vector2d(inset, inset),
                                    Eigen::Vector2d(given.width - inset, given.depth - inset));
    const double shift = given.twins ? 0.0 : length(random, -0.06, 0.06);
    ways.cross = rounded(given.width * (0.5 + shift));
    ways.storeyHeight = StoreyHeight;
    const double free = given.width - 2 * roomDepth - ShaftLength;
    for (int storey = 0; storey + 1 < given.storeys; ++storey) {
        const double share = given.twins ? 0.5 : random.uniform();
        shaftsAt.push_back(rounded(-(given.width - 2 * roomDepth) / 2 + share * free));
    }
}

double Plan::rounded(double value) {
    return std::round(value * 1000.0) / 1000.0;
}

double Plan::length(Random& dice, double least, double most) {
    return rounded(dice.between(least, most));
}

Element& Plan::add(Element element, const Spot& spot, double x, double y, double up, double turn) {
    const Eigen::Vector2d at = spot.inArena(x, y);
    element.size = element.size.unaryExpr(&Plan::rounded);
    element.pose = poseFrom({rounded(at.x()), rounded(at.y()), rounded(spot.base + up)}, 0.0, 0.0,
                            degrees(std::fmod(90.0 * spot.quarter + std::round(turn * 10.0) / 10.0, 360.0)));
    element.name =
        fmt::format("{} {}", toString(element.kind), ++m_count[static_cast<std::size_t>(element.kind)]);
    arena.elements.push_back(std::move(element));
    return arena.elements.back();
}

void Plan::wall(const Spot& spot, double first, double last, double y, double height, Material material) {
    if (last - first < 0.01) return;
    Element wall = elementOf(ElementKind::Wall);
    wall.size = {last - first, Thickness, height};
    wall.material = material;
    add(wall, spot, (first + last) / 2, y);
}

void Plan::partition(const Spot& spot, double x, double first, double last, double height) {
    Element wall = elementOf(ElementKind::Wall);
    wall.size = {last - first, Thickness, height};
    wall.material = Material::Plaster;
    add(wall, spot, x, (first + last) / 2, 0.0, 90.0);
}

Random Plan::roomDice() {
    return Random(settings.twins ? m_roomSeed : random.next());
}

std::array<Strip, 4> Plan::outerStrips(int storey) const {
    const double base = rounded(storey * StoreyHeight);
    const double w = settings.width, d = settings.depth, r = roomDepth;
    return {{{{{w / 2, r}, 2, base}, w - 2 * r, r},
             {{{r, d / 2}, 1, base}, d - 2 * r, r},
             {{{w / 2, d - r}, 0, base}, w - 2 * r, r},
             {{{w - r, d / 2}, 3, base}, d - 2 * r, r}}};
}

}  // namespace leitstand::simulation::building
