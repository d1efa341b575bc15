#include <algorithm>
#include <cmath>

#include "robots/simulation/arena/mesh/element_meshes.h"

namespace leitstand::simulation {
namespace {

constexpr double LeafHeight = 2.0;  ///< of doors, at most [m]
constexpr double LeafThickness = 0.03;

/// Returns the number of pieces of @p length so that none is longer than what the texture shows.
int tilesFor(const MeshBuilder& builder, double length) {
    const double most = builder.look().textureSize;
    return most > 0.0 ? std::clamp(static_cast<int>(std::ceil(length / most - 0.05)), 1, 40) : 1;
}

}  // namespace

void addFloor(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d half = element.size / 2;
    const double low = -element.size.z();
    const auto at = [&](double x, double y, double z) { return Eigen::Vector3d(x, y, z); };
    // The top is cut into tiles that the texture fills; the other faces are whole.
    const int columns = tilesFor(builder, element.size.x());
    const int rows = tilesFor(builder, element.size.y());
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x0 = -half.x() + column * element.size.x() / columns;
            const double x1 = -half.x() + (column + 1) * element.size.x() / columns;
            const double y0 = -half.y() + row * element.size.y() / rows;
            const double y1 = -half.y() + (row + 1) * element.size.y() / rows;
            builder.face({at(x0, y0, 0), at(x1, y0, 0), at(x1, y1, 0), at(x0, y1, 0)});
        }
    }
    const double x = half.x();
    const double y = half.y();
    builder.face({at(-x, y, low), at(x, y, low), at(x, -y, low), at(-x, -y, low)});
    builder.face({at(-x, -y, low), at(x, -y, low), at(x, -y, 0), at(-x, -y, 0)});
    builder.face({at(x, -y, low), at(x, y, low), at(x, y, 0), at(x, -y, 0)});
    builder.face({at(x, y, low), at(-x, y, low), at(-x, y, 0), at(x, y, 0)});
    builder.face({at(-x, y, low), at(-x, -y, low), at(-x, -y, 0), at(-x, y, 0)});
}

void addWall(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d half = element.size / 2;
    // A wall is a row of sheets of the size they are sold in.
    const int sheets = tilesFor(builder, element.size.x());
    const double width = element.size.x() / sheets;
    for (int i = 0; i < sheets; ++i) {
        const double x = -half.x() + i * width;
        builder.box({x, -half.y(), 0.0}, {x + width, half.y(), element.size.z()});
    }
}

void addDoor(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d half = element.size / 2;
    const double opening = std::clamp(element.width, 0.0, element.size.x()) / 2;
    const double leaf = std::min(LeafHeight, element.size.z());
    if (opening < half.x()) {
        builder.box({-half.x(), -half.y(), 0.0}, {-opening, half.y(), element.size.z()});
        builder.box({opening, -half.y(), 0.0}, {half.x(), half.y(), element.size.z()});
    }
    if (leaf < element.size.z()) {
        builder.box({-opening, -half.y(), leaf}, {opening, half.y(), element.size.z()});
    }
    if (opening <= 0.02) return;
    Pose hinge = Pose::Identity();
    hinge.translate(Eigen::Vector3d(-opening, 0.0, 0.0));
    hinge.rotate(Eigen::AngleAxisd(element.angle, Eigen::Vector3d::UnitZ()));
    builder.box(hinge, {0.01, -LeafThickness / 2, 0.01},
                {2 * opening - 0.01, LeafThickness / 2, std::max(0.02, leaf - 0.01)});
}

void addRamp(MeshBuilder& builder, const Element& element) {
    const double x = element.size.x() / 2;
    const std::array<Eigen::Vector2d, 3> profile = {
        Eigen::Vector2d(-x, 0.0), {x, 0.0}, {x, element.size.z()}};
    builder.prism(profile, -element.size.y() / 2, element.size.y() / 2);
}

void addStairs(MeshBuilder& builder, const Element& element) {
    const Eigen::Vector3d& size = element.size;
    const int steps =
        std::clamp(static_cast<int>(std::lround(size.z() / std::max(element.riser, 0.005))), 1, 200);
    const double riser = size.z() / steps;
    const double tread = size.x() / steps;
    const double y = size.y() / 2;
    const auto at = [&](int column, double y, int row) {
        return Eigen::Vector3d(-size.x() / 2 + column * tread, y, row * riser);
    };
    for (int i = 0; i < steps; ++i) {
        builder.face({at(i, -y, i), at(i, -y, i + 1), at(i, y, i + 1), at(i, y, i)});
        builder.face({at(i, -y, i + 1), at(i + 1, -y, i + 1), at(i + 1, y, i + 1), at(i, y, i + 1)});
        builder.face({at(i, -y, 0), at(i + 1, -y, 0), at(i + 1, -y, i + 1), at(i, -y, i + 1)});
        builder.face({at(i + 1, y, 0), at(i, y, 0), at(i, y, i + 1), at(i + 1, y, i + 1)});
    }
    builder.face({at(steps, -y, 0), at(steps, y, 0), at(steps, y, steps), at(steps, -y, steps)});
    builder.face({at(0, y, 0), at(steps, y, 0), at(steps, -y, 0), at(0, -y, 0)});
}

void addStepField(MeshBuilder& builder, const Element& element) {
    const double cell = element.cell;
    if (!(cell > 0.0)) return;
    const int columns = static_cast<int>(std::lround(element.size.x() / cell));
    const int rows = static_cast<int>(std::lround(element.size.y() / cell));
    const auto height = [&](int column, int row) {
        const auto place = static_cast<std::size_t>(row * columns + column);
        const bool inside = column >= 0 && row >= 0 && column < columns && row < rows;
        return inside && place < element.heights.size() ? element.heights[place] : 0.0;
    };
    const auto at = [&](int column, int row, double z) {
        return Eigen::Vector3d(-element.size.x() / 2 + column * cell, -element.size.y() / 2 + row * cell, z);
    };
    // Only faces that no neighbour hides; where the height is 0, the floor shows.
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double h = height(column, row);
            if (h <= 0.0) continue;
            builder.face({at(column, row, h), at(column + 1, row, h), at(column + 1, row + 1, h),
                          at(column, row + 1, h)});
            builder.face({at(column, row + 1, 0), at(column + 1, row + 1, 0), at(column + 1, row, 0),
                          at(column, row, 0)});
            if (const double low = height(column, row - 1); low < h) {
                builder.face({at(column, row, low), at(column + 1, row, low), at(column + 1, row, h),
                              at(column, row, h)});
            }
            if (const double low = height(column + 1, row); low < h) {
                builder.face({at(column + 1, row, low), at(column + 1, row + 1, low),
                              at(column + 1, row + 1, h), at(column + 1, row, h)});
            }
            if (const double low = height(column, row + 1); low < h) {
                builder.face({at(column + 1, row + 1, low), at(column, row + 1, low), at(column, row + 1, h),
                              at(column + 1, row + 1, h)});
            }
            if (const double low = height(column - 1, row); low < h) {
                builder.face({at(column, row + 1, low), at(column, row, low), at(column, row, h),
                              at(column, row + 1, h)});
            }
        }
    }
}

}  // namespace leitstand::simulation
