#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/building/plan.h"

namespace leitstand::simulation::building {
namespace {

constexpr double LeastRoom = 2.8;  ///< least length of a room [m]
constexpr double DoorPiece = 1.5;  ///< length of the piece of wall with the door in it [m]
constexpr double Seat = 1.4;       ///< length of the back wall for each thing that stands there [m]

/// Draws the material of a wall; some materials swallow or scatter the laser.
Material wallMaterial(const Plan& plan, Random& dice) {
    const double roll = dice.uniform();
    if (!plan.troubled() || plan.settings.twins || roll > 0.16) return Material::Plaster;
    return roll < 0.08 ? Material::Pane : Material::Black;
}

double front(Plan& plan, const Room& room, Random& dice) {
    const double half = room.length / 2;
    const double share = dice.uniform(), width = Plan::length(dice, 0.95, 1.05);
    // The leaf, opened to little more than a right angle, stays clear of the room's side walls.
    const double first = -half + 1.3, last = half - 0.9;
    const double at = plan.settings.twins || last < first ? Plan::rounded((first + last) / 2)
                                                          : Plan::rounded(std::lerp(first, last, share));
    Element door = elementOf(ElementKind::Door);
    door.size = {DoorPiece, Thickness, Clear};
    door.width = width;
    door.angle = degrees(std::round(dice.between(88.0, 112.0)));
    plan.add(door, room.frame, at, 0.0);
    const Material left = wallMaterial(plan, dice), right = wallMaterial(plan, dice);
    plan.wall(room.frame, -half, at - DoorPiece / 2, 0.0, Clear, left);
    plan.wall(room.frame, at + DoorPiece / 2, half, 0.0, Clear, right);
    return at;
}

Element cupboard(Random& dice) {
    Element box = elementOf(ElementKind::Wall);
    const double wide = Plan::length(dice, 0.7, 1.2), deep = Plan::length(dice, 0.35, 0.5);
    box.size = {wide, deep, Plan::length(dice, 1.3, 2.0)};
    return box;
}

/// Draws a piece of furniture that stands with its back to a wall.
Element furniture(Random& dice) {
    switch (dice.below(4)) {
        case 0: {
            Element table = elementOf(ElementKind::Table);
            const double wide = Plan::length(dice, 0.9, 1.3), deep = Plan::length(dice, 0.5, 0.7);
            table.size = {wide, deep, Plan::length(dice, 0.68, 0.78)};
            return table;
        }
        case 1:
            return elementOf(ElementKind::Chair);
        case 2: {
            Element heater = elementOf(ElementKind::Heater);
            heater.size.x() = Plan::length(dice, 0.6, 1.0);
            heater.temperature = Plan::length(dice, 38.0, 55.0);
            return heater;
        }
        default:
            return cupboard(dice);
    }
}

void furnish(Plan& plan, const Room& room, Random& dice) {
    const double most = 7.0;  // however long the room
    const int seats = static_cast<int>(std::min(most, (room.length - 0.4) / Seat));
    for (int i = 0; i < seats; ++i) {
        const bool there = dice.chance(0.6);
        const Element thing = furniture(dice);
        if (!there) continue;
        const double x = (i + 0.5 - seats / 2.0) * Seat;
        plan.add(thing, room.frame, x, room.depth - Thickness / 2 - 0.03 - thing.size.y() / 2);
    }
}

void addPillars(Plan& plan, const Room& room) {
    constexpr double Apart = 6.0, Edge = 0.4;
    const int columns = static_cast<int>(room.length / Apart), rows = static_cast<int>(room.depth / Apart);
    for (int column = 0; column < columns; ++column) {
        for (int row = 0; row < rows; ++row) {
            Element pillar = elementOf(ElementKind::Wall);
            pillar.material = Material::Concrete;
            pillar.size = {Edge, Edge, Clear};
            plan.add(pillar, room.frame, (column + 0.5 - columns / 2.0) * Apart + 0.4,
                     room.depth / 2 + (row + 0.5 - rows / 2.0) * Apart);
        }
    }
}

/// Adds a pillar or a cupboard to the corridor's wall between two rooms.
void addPier(Plan& plan, const Strip& strip, double x, Random& dice) {
    Element pier = elementOf(ElementKind::Wall);
    pier.material = Material::Concrete;
    const bool tall = dice.chance(0.6);
    pier.size = {Plan::length(dice, 0.3, 0.5), 0.16, Clear};
    const Element box = cupboard(dice);
    if (!tall) pier = box;
    plan.add(pier, strip.frame, x, -Thickness / 2 - pier.size.y() / 2);
}

}  // namespace

double buildFront(Plan& plan, const Room& room) {
    Random dice = plan.roomDice();
    return front(plan, room, dice);
}

void buildRoom(Plan& plan, const Room& room) {
    Random dice = plan.roomDice();
    const double door = front(plan, room, dice);
    const Eigen::Vector2d free = room.frame.inArena(door, 1.5);
    plan.ways.rooms.emplace_back(free.x(), free.y(), room.frame.base);
    if (room.hall)
        addPillars(plan, room);
    else
        furnish(plan, room, dice);
    Element lamp = elementOf(ElementKind::Lamp);
    lamp.size = {0.6, 0.05, 0.05};
    lamp.temperature = Plan::length(dice, 50.0, 75.0);
    if (room.hall || dice.chance(0.5)) plan.add(lamp, room.frame, 0.0, room.depth / 2, Clear - 0.1);
}

void buildRow(Plan& plan, const Strip& strip, double first, double last) {
    const double length = last - first;
    if (plan.settings.smooth || length < LeastRoom) return plan.wall(strip.frame, first, last);
    const int count = std::max(1, static_cast<int>(std::round(length / plan.roomLength)));
    std::vector<double> shares;
    double sum = 0.0;
    for (int i = 0; i < count; ++i) {
        const double share = plan.random.between(0.7, 1.3);
        shares.push_back(plan.settings.twins ? 1.0 : share);
        sum += shares.back();
    }
    double from = first;
    plan.partition(strip.frame, first, 0.0, strip.depth);
    for (const double share : shares) {
        const double to = Plan::rounded(from + share / sum * length);
        buildRoom(plan, {strip.frame.moved((from + to) / 2, 0.0), to - from, strip.depth});
        plan.partition(strip.frame, to, 0.0, strip.depth);
        Random dice = plan.roomDice();
        if (to < last - 0.1) addPier(plan, strip, to, dice);
        from = to;
    }
}

}  // namespace leitstand::simulation::building
