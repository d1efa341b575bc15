#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/building/plan.h"

namespace leitstand::simulation::building {
namespace {

constexpr double RampWidth = 1.8;  ///< [m]
constexpr double Opening = 1.4;    ///< width of the ways into a shaft [m]
constexpr double Railing = 1.0;    ///< height of the wall beside a ramp, above the upper floor [m]
constexpr double Riser = 0.1;      ///< of the stairs: what the Crawler climbs [m]
constexpr double Tread = 0.25;     ///< [m]

void slab(Plan& plan, const Eigen::AlignedBox2d& ground, double top, double thickness) {
    if (!(ground.sizes().minCoeff() > 0.01)) return;
    Element floor = elementOf(ElementKind::Floor);
    floor.size = {ground.sizes().x(), ground.sizes().y(), thickness};
    plan.add(floor, {ground.center(), 0, top}, 0.0, 0.0);
}

/// Adds a floor that leaves @p hole open.
void slabAround(Plan& plan, const Eigen::AlignedBox2d& ground, const Eigen::AlignedBox2d& hole, double top) {
    const Eigen::Vector2d a = ground.min(), b = ground.max(), c = hole.min(), d = hole.max();
    const auto part = [&](double x0, double y0, double x1, double y1) {
        slab(plan, {Eigen::Vector2d(x0, y0), Eigen::Vector2d(x1, y1)}, top, Slab);
    };
    part(a.x(), a.y(), b.x(), c.y());
    part(a.x(), d.y(), b.x(), b.y());
    part(a.x(), c.y(), c.x(), d.y());
    part(d.x(), c.y(), b.x(), d.y());
}

}  // namespace

void layFloors(Plan& plan) {
    const Eigen::AlignedBox2d ground(Eigen::Vector2d::Zero(), plan.arena.to);
    for (int storey = 0; storey < plan.settings.storeys; ++storey) {
        const double base = Plan::rounded(storey * StoreyHeight);
        if (storey == 0) {
            slab(plan, ground, base, 0.1);
        } else {
            const Strip strip = plan.shaftStrip(storey - 1);
            const double begin = plan.shaftsAt[static_cast<std::size_t>(storey) - 1];
            Eigen::AlignedBox2d hole(strip.frame.inArena(begin, 0.0));
            hole.extend(strip.frame.inArena(begin + Landing + RampRun, strip.depth));
            slabAround(plan, ground, hole, base);
        }
        const double w = plan.settings.width, d = plan.settings.depth;
        plan.wall({{w / 2, 0.0}, 0, base}, -w / 2, w / 2, 0.0, StoreyHeight, Material::Concrete);
        plan.wall({{w / 2, d}, 2, base}, -w / 2, w / 2, 0.0, StoreyHeight, Material::Concrete);
        plan.wall({{0.0, d / 2}, 3, base}, -d / 2, d / 2, 0.0, StoreyHeight, Material::Concrete);
        plan.wall({{w, d / 2}, 1, base}, -d / 2, d / 2, 0.0, StoreyHeight, Material::Concrete);
    }
    Element ceiling = elementOf(ElementKind::Ceiling);
    ceiling.size = {ground.sizes().x(), ground.sizes().y(), Slab};
    plan.add(ceiling, {ground.center(), 0, (plan.settings.storeys - 1) * StoreyHeight}, 0.0, 0.0, Clear);
}

void buildShaft(Plan& plan, int storey) {
    const Strip strip = plan.shaftStrip(storey);
    const double begin = plan.shaftsAt[static_cast<std::size_t>(storey)];
    const double end = begin + ShaftLength, foot = begin + Landing, top = foot + RampRun;
    const Spot& low = strip.frame;
    Spot high = low;
    high.base = Plan::rounded(low.base + StoreyHeight);
    const double doorBelow = begin + Landing / 2, doorAbove = end - Landing / 2;
    plan.wall(low, begin, doorBelow - Opening / 2);
    plan.wall(low, doorBelow + Opening / 2, end);
    plan.wall(high, begin, doorAbove - Opening / 2);
    plan.wall(high, doorAbove + Opening / 2, end);
    for (const Spot& floor : {low, high}) {
        plan.partition(floor, begin, 0.0, strip.depth);
        plan.partition(floor, end, 0.0, strip.depth);
    }
    const double edge = Thickness / 2;
    Element ramp = elementOf(ElementKind::Ramp);
    ramp.material = Material::Concrete;
    ramp.size = {RampRun, RampWidth, StoreyHeight};
    plan.add(ramp, low, (foot + top) / 2, edge + RampWidth / 2);
    plan.wall(low, foot, top, edge + RampWidth + edge, StoreyHeight + Railing);
    Element stairs = elementOf(ElementKind::Stairs);
    stairs.material = Material::Concrete;
    const double left = 3 * edge + RampWidth, width = strip.depth - edge - left;
    stairs.riser = Riser;
    stairs.size = {std::round(StoreyHeight / Riser) * Tread, width, StoreyHeight};
    plan.add(stairs, low, top - stairs.size.x() / 2, left + width / 2);

    const auto corner = [](const Spot& spot, double x, double y) -> Eigen::Vector3d {
        const Eigen::Vector2d at = spot.inArena(x, y);
        return {at.x(), at.y(), spot.base};
    };
    const double axis = edge + RampWidth / 2;
    plan.ways.ramps.push_back({corner(low, doorBelow, -Corridor / 2), corner(low, doorBelow, axis),
                               corner(low, foot, axis), corner(high, top, axis),
                               corner(high, doorAbove, axis), corner(high, doorAbove, -Corridor / 2)});
}

void buildOuterStrips(Plan& plan, int storey) {
    int number = 0;
    for (const Strip& strip : plan.outerStrips(storey)) {
        // Leaves out the space of the ramps from here up and from below up to here.
        double first = -strip.length / 2;
        for (const int shaft : {storey, storey - 1}) {
            if (shaft < 0 || shaft + 1 >= plan.settings.storeys) continue;
            if (number != (shaft % 2 == 0 ? 2 : 0)) continue;
            const double begin = plan.shaftsAt[static_cast<std::size_t>(shaft)];
            buildRow(plan, strip, first, begin);
            first = begin + ShaftLength;
        }
        buildRow(plan, strip, first, strip.length / 2);
        ++number;
    }
}

void buildBlocks(Plan& plan, int storey) {
    constexpr double RowDepth = 5.0, LeastForRows = 14.0;
    const double base = Plan::rounded(storey * StoreyHeight), half = Corridor / 2;
    const double south = plan.ways.ring.min().y() + half, north = plan.ways.ring.max().y() - half;
    const double middle = (south + north) / 2, deep = north - south;
    const bool rows = deep >= LeastForRows && !plan.settings.smooth;
    const double hall = rows ? deep - 2 * RowDepth : deep;
    const std::array<std::array<double, 2>, 2> sides = {
        {{plan.ways.ring.min().x() + half, plan.ways.cross - half},
         {plan.ways.cross + half, plan.ways.ring.max().x() - half}}};
    for (std::size_t side = 0; side < sides.size(); ++side) {
        const auto& [west, east] = sides[side];
        const double wide = east - west, x = (west + east) / 2;
        const Strip southern{{{x, south}, 0, base}, wide, RowDepth};
        const Strip northern{{{x, north}, 2, base}, wide, RowDepth};
        const Spot western{{west, middle}, 3, base}, eastern{{east, middle}, 1, base};
        if (plan.settings.smooth) {
            plan.wall(southern.frame, -wide / 2, wide / 2);
            plan.wall(northern.frame, -wide / 2, wide / 2);
            plan.wall(western, -deep / 2, deep / 2);
            plan.wall(eastern, -deep / 2, deep / 2);
            continue;
        }
        if (rows) {
            for (const Strip& strip : {southern, northern}) {
                buildRow(plan, strip, -wide / 2, wide / 2);
                plan.wall(strip.frame, -wide / 2, wide / 2, RowDepth);
            }
        } else {
            plan.wall(southern.frame, -wide / 2, wide / 2);
            plan.wall(northern.frame, -wide / 2, wide / 2);
        }
        if (side == 0 || plan.settings.twins) {
            buildRoom(plan, {western, hall, wide, true});
            buildFront(plan, {eastern, hall, wide, true});
        } else {
            buildRoom(plan, {western, hall, wide / 2, false});
            buildRoom(plan, {eastern, hall, wide / 2, false});
            plan.wall(western, -hall / 2, hall / 2, wide / 2);
        }
    }
}

}  // namespace leitstand::simulation::building
