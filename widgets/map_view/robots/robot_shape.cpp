#include "widgets/map_view/robots/robot_shape.h"

#include <algorithm>
#include <array>

#include <Eigen/Geometry>

#include "widgets/models/map/robots/robot_mark.h"

namespace leitstand {
namespace {

using Facets = std::vector<RobotFacet>;

/// Returns the brightness of a side with normal @p outward: greatest from above, then from ahead and from the
/// left.
double lightOf(const Eigen::Vector3d& outward) {
    return 0.72 + 0.28 * outward.z() + 0.10 * outward.x() + 0.06 * outward.y();
}

void addBox(Facets& facets, const Eigen::AlignedBox3d& box, RobotPart part) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-1.0, 1.0}) {
            RobotFacet facet;
            facet.part = part;
            facet.outward = side * Eigen::Vector3d::Unit(axis);
            facet.light = lightOf(facet.outward);
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const std::array<std::array<double, 2>, 4> turn = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
            for (const auto& [along, across] : turn) {
                Eigen::Vector3d corner = box.center();
                corner[axis] += side * box.sizes()[axis] / 2;
                corner[u] += along * box.sizes()[u] / 2;
                corner[v] += side * across * box.sizes()[v] / 2;  // the other way round on the far side
                facet.corners.push_back(corner);
            }
            if (side < 0) std::reverse(facet.corners.begin(), facet.corners.end());
            facets.push_back(std::move(facet));
        }
    }
}

Eigen::AlignedBox3d boxOf(double x0, double x1, double y0, double y1, double z0, double z1) {
    return {Eigen::Vector3d(x0, y0, z0), Eigen::Vector3d(x1, y1, z1)};
}

/// Adds one long chain per side, or three wheels per side.
void addGear(Facets& facets, const Eigen::AlignedBox2d& plan, double width, double height, bool tracked) {
    const double length = plan.sizes().x(), wheel = std::min(height, 0.28 * length);
    for (const double y : {plan.min().y(), plan.max().y() - width}) {
        if (tracked) {
            addBox(facets, boxOf(plan.min().x(), plan.max().x(), y, y + width, 0.0, height), RobotPart::Gear);
            continue;
        }
        for (const double share : {0.14, 0.5, 0.86}) {
            const double x = plan.min().x() + share * length;
            addBox(facets, boxOf(x - wheel / 2, x + wheel / 2, y, y + width, 0.0, wheel), RobotPart::Gear);
        }
    }
}

}  // namespace

std::vector<RobotFacet> robotFacets(const RobotMark& robot) {
    Eigen::AlignedBox2d plan(Eigen::Vector2d(-0.2, -0.15), Eigen::Vector2d(0.2, 0.15));
    if (robot.footprint.size() >= 3) {
        plan.setEmpty();
        for (const Eigen::Vector2d& corner : robot.footprint) plan.extend(corner);
    }
    const double length = plan.sizes().x(), width = plan.sizes().y();
    const double height = std::max(robot.height, 0.15);
    const double gear = (robot.tracked ? 0.24 : 0.18) * width;
    const double gearHeight = std::min(robot.tracked ? 0.45 * height : 0.25 * height, 0.2);
    const double top = std::max(gearHeight + 0.03, 0.4 * height);
    Facets facets;
    addGear(facets, plan, gear, gearHeight, robot.tracked);
    addBox(facets,
           boxOf(plan.min().x(), plan.max().x(), plan.min().y() + gear, plan.max().y() - gear,
                 0.4 * gearHeight, top),
           RobotPart::Body);
    const double mast = 0.11 * width, behind = plan.min().x() + 0.25 * length;
    const double middle = plan.center().y();
    addBox(facets, boxOf(behind - mast, behind + mast, middle - mast, middle + mast, top, height),
           RobotPart::Mast);
    const double above = top + 0.01, tip = plan.max().x(), back = behind + 2 * mast;
    facets.push_back(
        {{{tip, middle, above}, {back, middle + 0.3 * width, above}, {back, middle - 0.3 * width, above}},
         Eigen::Vector3d::UnitZ(),
         RobotPart::Arrow,
         1.0});
    return facets;
}

}  // namespace leitstand
