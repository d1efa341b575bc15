#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include <fmt/format.h>

#include "robots/simulation/arena/building/plan.h"
#include "robots/simulation/arena/mesh/sign_pictures.h"

namespace leitstand::simulation::building {
namespace {

/// Returns the corridors of a storey: frames in their middle, x along them, with their lengths.
std::vector<Strip> corridors(const Plan& plan, int storey) {
    const double base = Plan::rounded(storey * StoreyHeight);
    const Eigen::Vector2d middle = plan.ways.ring.center(), size = plan.ways.ring.sizes();
    const Eigen::Vector2d low = plan.ways.ring.min(), high = plan.ways.ring.max();
    return {{{{middle.x(), low.y()}, 0, base}, size.x(), Corridor},
            {{{high.x(), middle.y()}, 1, base}, size.y(), Corridor},
            {{{middle.x(), high.y()}, 2, base}, size.x(), Corridor},
            {{{low.x(), middle.y()}, 3, base}, size.y(), Corridor},
            {{{plan.ways.cross, middle.y()}, 1, base}, size.y(), Corridor}};
}

/// Returns whether a corridor's wall is bare at @p at: no door, no sign, no pier, no way to a ramp.
bool isBare(const Plan& plan, const Eigen::Vector3d& at) {
    constexpr double Around = 0.3, WayToRamp = 2.0;
    for (const auto& ramp : plan.ways.ramps) {
        for (const Eigen::Vector3d& end : {ramp.front(), ramp.back()})
            if ((end - at).norm() < WayToRamp) return false;
    }
    return std::none_of(plan.arena.elements.begin(), plan.arena.elements.end(), [&](const Element& other) {
        const bool pier = other.kind == ElementKind::Wall && other.size.y() > Thickness + 0.01;
        if (!pier && other.kind != ElementKind::Door && other.kind != ElementKind::Sign) return false;
        const Eigen::Vector3d apart = (other.pose.inverse() * at).cwiseAbs();
        return apart.x() < other.size.x() / 2 + Around && apart.y() < other.size.y() / 2 + Around &&
               apart.z() < StoreyHeight;
    });
}

void addSign(Plan& plan, const Strip& corridor, int number) {
    Element sign = elementOf(ElementKind::Sign);
    const auto& hazards = hazardNames();
    const bool code = plan.random.chance(0.4);
    const int hazard = plan.random.below(static_cast<int>(hazards.size()));
    sign.text =
        code ? fmt::format("qr:building-{}", number) : "hazard:" + hazards[static_cast<std::size_t>(hazard)];
    const double edge = code ? 0.2 : 0.25;
    sign.size = {edge, 0.01, edge};
    const double up = Plan::length(plan.random, 0.5, 0.9);
    const double y = Corridor / 2 - Thickness / 2 - 0.006;
    for (int tries = 0; tries < 50; ++tries) {
        const double x = plan.random.between(-0.4, 0.4) * corridor.length;
        // On the left or on the right wall, facing the corridor.
        const bool left = plan.random.chance(0.5);
        const Eigen::Vector2d at = corridor.frame.inArena(x, left ? y : -y);
        if (!isBare(plan, {at.x(), at.y(), corridor.frame.base})) continue;
        plan.add(sign, corridor.frame, x, left ? y : -y, up, left ? 0.0 : 180.0);
        return;
    }
}

/// Returns whether nothing on the same floor stands within @p around of @p at, seen from above [m].
bool isFree(const Arena& arena, const Eigen::Vector3d& at, double around) {
    return std::none_of(arena.elements.begin(), arena.elements.end(), [&](const Element& other) {
        if (other.kind == ElementKind::Floor || other.kind == ElementKind::Ceiling ||
            other.kind == ElementKind::Lamp || other.kind == ElementKind::Smoke)
            return false;
        const Eigen::Vector3d apart = other.pose.inverse() * at;
        if (apart.z() < -1.0 || apart.z() > 2.0) return false;
        const double x = std::max(0.0, std::abs(apart.x()) - other.size.x() / 2);
        const double leaf = other.kind == ElementKind::Door ? 1.1 : 0.0;  // how far it opens
        const double y =
            std::max({0.0, apart.y() - std::max(leaf, other.size.y() / 2), -apart.y() - other.size.y() / 2});
        return std::hypot(x, y) < around;
    });
}

}  // namespace

void furnishCorridors(Plan& plan, int storey) {
    constexpr double LampsApart = 9.0;
    constexpr int Signs = 6;
    const auto all = corridors(plan, storey);
    for (const Strip& corridor : all) {
        const int lamps = std::max(1, static_cast<int>(corridor.length / LampsApart));
        for (int i = 0; i < lamps; ++i) {
            Element lamp = elementOf(ElementKind::Lamp);
            lamp.size = {1.2, 0.06, 0.06};
            plan.add(lamp, corridor.frame, (i + 0.5 - lamps / 2.0) * corridor.length / lamps, 0.0,
                     Clear - 0.1);
        }
    }
    for (int i = 0; i < Signs; ++i) {
        addSign(plan, all[static_cast<std::size_t>(i) % all.size()], storey * Signs + i + 1);
    }
}

void makeTrouble(Plan& plan, int storey) {
    const auto all = corridors(plan, storey);
    // Smoke in the cross corridor and at one place of the ring, away from where robots start.
    for (const std::size_t where : {std::size_t{4}, std::size_t{1}}) {
        Element smoke = elementOf(ElementKind::Smoke);
        smoke.size = {Plan::length(plan.random, 4.0, 8.0), Corridor - 0.2, Clear - 0.1};
        smoke.reach = Plan::length(plan.random, 1.5, 3.0);
        const double x = plan.random.between(-0.2, 0.2) * all[where].length;
        plan.add(smoke, all[where].frame, x, 0.0);
    }
    for (const std::size_t where : {std::size_t{2}, std::size_t{3}, std::size_t{4}}) {
        Element person = elementOf(ElementKind::Spectator);
        person.size.z() = Plan::length(plan.random, 1.55, 1.9);
        person.seed = plan.random.next() % 1000;
        person.width = Plan::length(plan.random, 1.0, 2.5);
        const double x = plan.random.between(-0.25, 0.25) * all[where].length;
        plan.add(person, all[where].frame, x, plan.random.chance(0.5) ? 0.5 : -0.5);
    }
}

namespace {

/// Where a victim lies; robots reach it from -y of its frame.
struct Bed {
    Spot frame;
    std::size_t place = 0;  ///< index of its room or corner
};

/// Draws a bed in a room: beside the way through its door, with space around and in front of it. Empty when
/// the draw does not fit.
std::optional<Bed> bedInRoom(Plan& plan) {
    constexpr double Around = 0.75, Before = 0.3, OffTheWay = 1.0, FromStart = 4.0;
    const auto& rooms = plan.ways.rooms;
    const auto place = static_cast<std::size_t>(plan.random.below(static_cast<int>(rooms.size())));
    const double x = Plan::length(plan.random, -1.5, 1.5), y = Plan::length(plan.random, -1.5, 1.5);
    const Eigen::Vector3d at = rooms[place] + Eigen::Vector3d(x, y, 0.0);
    const Bed bed{{at.head<2>(), plan.random.below(4), at.z()}, place};
    const double away = (at - plan.arena.starts.at("kurt3d").translation()).norm();
    if (std::hypot(x, y) < OffTheWay || away < FromStart || !isFree(plan.arena, at, Around)) return {};
    for (const double distance : {0.5, 0.8}) {
        const Eigen::Vector2d before = bed.frame.inArena(0.2, -distance);
        if (!isFree(plan.arena, {before.x(), before.y(), at.z()}, Before)) return {};
    }
    return bed;
}

/// Returns a bed in a corner of a bare ring, at its outer wall.
Bed bedInCorner(const Plan& plan, std::size_t number) {
    const Eigen::Vector2d low = plan.ways.ring.min(), high = plan.ways.ring.max();
    const double base = Plan::rounded(static_cast<double>(number / 3) * StoreyHeight);
    switch (number % 3) {
        case 0:
            return {{{high.x() + 0.55, low.y() - 0.85}, 2, base}, number};
        case 1:
            return {{{high.x() + 0.55, high.y() + 0.85}, 0, base}, number};
        default:
            return {{{low.x() - 0.55, high.y() + 0.85}, 0, base}, number};
    }
}

}  // namespace

void layVictims(Plan& plan) {
    constexpr int VictimsOfStorey = 3, Tries = 600;
    const int most = VictimsOfStorey * plan.settings.storeys;
    std::set<std::size_t> taken;
    for (int tries = 0; tries < Tries && static_cast<int>(taken.size()) < most; ++tries) {
        const std::optional<Bed> bed =
            plan.settings.smooth ? std::optional(bedInCorner(plan, taken.size())) : bedInRoom(plan);
        if (!bed || !taken.insert(bed->place).second) continue;
        const auto number = taken.size();
        Element victim = elementOf(ElementKind::Victim);
        victim.size = {1.0, 0.3, 0.2};
        victim.seed = plan.random.next() % 1000;
        VictimTraits& traits = *victim.victim;
        traits.tag = fmt::format("V-{:02}", number);
        traits.situation = number % 3 == 0 ? Situation::Trapped : Situation::Surface;
        traits.temperature = Plan::rounded(std::round(plan.random.between(30.0, 37.0) * 10.0) / 10.0);
        traits.co2 = std::round(plan.random.between(20.0, 60.0)) * 100.0;
        traits.waving = plan.random.chance(0.4);
        plan.add(victim, bed->frame, 0.0, 0.0);
    }
}

}  // namespace leitstand::simulation::building
