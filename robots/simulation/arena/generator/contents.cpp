#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include <fmt/format.h>

#include "robots/simulation/arena/generator/plan.h"
#include "robots/simulation/arena/mesh/sign_pictures.h"

namespace leitstand::simulation {
namespace {

Situation situationFor(Plan& plan) {
    const double dice = plan.random.uniform();
    const double open = plan.arena.grade == Grade::Yellow ? 0.6 : 0.35;
    if (dice < open) return Situation::Surface;
    if (dice < open + 0.2) return Situation::Trapped;
    return dice < 0.93 ? Situation::Void : Situation::Entombed;
}

Element victimFor(Plan& plan, int number) {
    Element victim = elementOf(ElementKind::Victim);
    victim.size = {plan.length(0.95, 1.05), 0.3, 0.2};
    victim.seed = plan.random.next() % 1000;
    VictimTraits& traits = *victim.victim;
    // The first ones can be found by heat.
    traits.situation = number <= 2 ? Situation::Surface : situationFor(plan);
    const bool alive = number <= 3 || plan.random.chance(0.85);
    traits.tag = fmt::format("V-{:02}", number);
    traits.temperature =
        alive ? Plan::rounded(std::round(plan.random.between(30.0, 37.0) * 10.0) / 10.0) : 20.0;
    traits.co2 = alive ? std::round(plan.random.between(20.0, 60.0)) * 100.0 : 0.0;
    traits.waving = alive && traits.situation <= Situation::Trapped && plan.random.chance(0.4);
    traits.hidden = traits.situation == Situation::Entombed;
    return victim;
}

void addFoil(Plan& plan, const Plan::Niche& niche, double distance, double width) {
    Element foil = elementOf(ElementKind::Foil);
    foil.size = {Plan::rounded(width), 0.04, plan.length(0.5, 0.7)};
    foil.pose = plan.before(niche.cell, niche.side, distance);
    foil.seed = plan.random.next() % 1000;
    plan.add(foil);
}

}  // namespace

void addVictims(Plan& plan, int count) {
    for (int number = 1; number <= count; ++number) {
        // Victims do not lie where robots start.
        const auto far = [&](const Cell& cell) {
            const Eigen::Vector3d start = plan.arena.starts["kurt3d"].translation();
            return (plan.middle(cell) - start).norm() > 1.8;
        };
        const auto niche = plan.niche(far);
        if (!niche) return;
        plan.take(niche->cell);
        Element victim = victimFor(plan, number);
        const bool boxed = victim.victim->situation >= Situation::Void;
        victim.pose = plan.before(niche->cell, niche->side, victim.size.y() / 2 + (boxed ? 0.08 : 0.04));
        const bool behindFoil = number == 3 && victim.victim->situation == Situation::Surface;
        plan.add(victim);
        if (behindFoil) addFoil(plan, *niche, 0.55, 1.0);
    }
}

void addFurniture(Plan& plan, int count) {
    for (int i = 0; i < count; ++i) {
        const auto niche = plan.niche();
        if (!niche) return;
        plan.take(niche->cell);
        const int kind = plan.random.below(3);
        if (kind == 0) {
            Element table = elementOf(ElementKind::Table);
            table.size = {plan.length(0.7, 0.95), plan.length(0.4, 0.48), plan.length(0.42, 0.55)};
            table.pose = plan.before(niche->cell, niche->side, table.size.y() / 2 + 0.02);
            plan.add(table);
        } else if (kind == 1) {
            Element chair = elementOf(ElementKind::Chair);
            chair.pose = plan.before(niche->cell, niche->side, 0.25, plan.length(-0.3, 0.3));
            plan.add(chair);
        } else {
            Element board = elementOf(ElementKind::Overhang);
            board.size = {plan.length(0.5, 0.9), plan.length(0.2, 0.35), 0.03};
            board.pose = plan.before(niche->cell, niche->side, board.size.y() / 2, plan.length(-0.1, 0.1),
                                     plan.length(0.3, 0.5));
            plan.add(board);
        }
    }
}

void addLamps(Plan& plan) {
    // Lamps on top of the walls give light.
    for (int i = 0; i < 5; ++i) {
        Element lamp = elementOf(ElementKind::Lamp);
        lamp.temperature = plan.length(50.0, 75.0);
        if (plan.random.chance(0.5)) lamp.size = {0.6, 0.05, 0.05};
        const Eigen::Vector3d node(plan.random.below(MazeEdge + 1) * CellEdge,
                                   plan.random.below(MazeEdge + 1) * CellEdge, WallHeight + 0.45);
        lamp.pose = Plan::upright(node, plan.random.chance(0.5) ? 0.0 : 90.0);
        plan.add(lamp);
    }
    // Low lamps distract from victims in a search for heat; one is behind foil.
    for (int i = 0; i < 2; ++i) {
        const auto niche = plan.niche();
        if (!niche) return;
        plan.take(niche->cell);
        Element lamp = elementOf(ElementKind::Lamp);
        lamp.temperature = plan.length(32.0, 60.0);
        lamp.pose =
            plan.before(niche->cell, niche->side, 0.1, plan.length(-0.3, 0.3), plan.length(0.05, 0.4));
        plan.add(lamp);
        if (i == 0) addFoil(plan, *niche, 0.25, 0.8);
    }
}

void addHeaters(Plan& plan, int count) {
    for (int i = 0; i < count; ++i) {
        const auto niche = plan.niche();
        if (!niche) return;
        plan.take(niche->cell);
        Element heater = elementOf(ElementKind::Heater);
        heater.size = {plan.length(0.4, 0.8), 0.1, plan.length(0.4, 0.6)};
        heater.temperature = plan.length(38.0, 60.0);
        heater.pose = plan.before(niche->cell, niche->side, 0.08);
        plan.add(heater);
    }
}

void addSoftThings(Plan& plan, int count) {
    for (int i = 0; i < count; ++i) {
        const auto cell = plan.freeCell();
        if (!cell) return;
        Element paper = elementOf(ElementKind::LoosePaper);
        paper.size = {plan.length(0.25, 0.45), plan.length(0.2, 0.35), plan.length(0.06, 0.16)};
        paper.seed = plan.random.next() % 1000;
        paper.pose = Plan::upright(
            plan.middle(*cell) + Eigen::Vector3d(plan.length(-0.35, 0.35), plan.length(-0.35, 0.35), 0.0),
            plan.random.between(0.0, 180.0));
        plan.add(paper);
    }
}

void addSigns(Plan& plan, int count) {
    std::set<std::tuple<int, int, Side>> hung;  // one per side, so that none hides another
    for (int i = 0, tries = 0; i < count && tries < 500; ++tries) {
        // Signs hang above what stands in front of a wall.
        const Cell cell{plan.random.below(MazeEdge), plan.random.below(MazeEdge)};
        const Side side = static_cast<Side>(plan.random.below(SideCount));
        if (plan.maze.border(cell, side) != Border::Wall) continue;
        if (!hung.emplace(cell.column, cell.row, side).second) continue;
        Element sign = elementOf(ElementKind::Sign);
        const bool code = plan.random.chance(0.4);
        const auto& hazards = hazardNames();
        sign.text =
            code ? fmt::format("qr:{}-{}", toString(plan.arena.grade), i + 1)
                 : "hazard:" +
                       hazards[static_cast<std::size_t>(plan.random.below(static_cast<int>(hazards.size())))];
        const double edge = code ? 0.2 : 0.25;
        sign.size = {edge, 0.01, edge};
        sign.pose = plan.before(cell, side, 0.006, plan.length(-0.35, 0.35), plan.length(0.45, 0.8));
        plan.add(sign);
        ++i;
    }
}

void addSpectators(Plan& plan, int count) {
    const double edge = MazeEdge * CellEdge;
    for (int i = 0; i < count; ++i) {
        Element person = elementOf(ElementKind::Spectator);
        person.size.z() = plan.length(1.55, 1.9);
        person.temperature = 33.0;
        person.seed = plan.random.next() % 1000;
        person.width = plan.random.chance(0.6) ? plan.length(0.3, 0.9) : 0.0;
        const int side = plan.random.below(4);
        const double along = plan.random.between(0.2, 0.8) * edge;
        const double away = plan.random.between(0.5, 1.6);
        const Eigen::Vector3d at = side == 0   ? Eigen::Vector3d(along, edge + away, 0.0)
                                   : side == 1 ? Eigen::Vector3d(-away, along, 0.0)
                                   : side == 2 ? Eigen::Vector3d(along, -away, 0.0)
                                               : Eigen::Vector3d(edge + away, along, 0.0);
        // Those who stand look at the arena; those who pace look along their way.
        const double inwards = 90.0 * side - 90.0;
        person.pose = Plan::upright(at, inwards + (person.width > 0.0 ? 90.0 : 0.0));
        plan.add(person);
    }
}

}  // namespace leitstand::simulation
