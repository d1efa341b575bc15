#include "core/handin/map/occupancy_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/cloud/labels.h"

namespace leitstand {

const std::vector<HeightBand>& reportBands() {
    static const std::vector<HeightBand> bands = {{0.25, 0.35}, {0.90, 1.10}};
    return bands;
}

std::vector<HeightBand> bandsOf(std::span<const ReportScan> scans, const FloorHeights& floor) {
    constexpr double About = 0.05;  // [m]; robots tilt a little
    std::optional<HeightBand> plane;
    for (const ReportScan& one : scans) {
        if (leavesPlane(one.scan->points)) return reportBands();
        const Eigen::Vector3d& laser = one.scanInMap.translation();
        const double height = laser.z() - floor.at(laser.x(), laser.y());
        if (!plane) plane = HeightBand{height - About, height + About};
        plane->low = std::min(plane->low, height - About);
        plane->high = std::max(plane->high, height + About);
    }
    return plane ? std::vector{*plane} : reportBands();
}

OccupancyGrid::Cell OccupancyGrid::at(double x, double y) const {
    const double column = std::floor((x - origin.x()) / cell + 1e-9),
                 row = std::floor((y - origin.y()) / cell + 1e-9);
    if (!(column >= 0.0 && row >= 0.0 && column < columns && row < rows)) return {};
    return cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(column)];
}

OccupancyGrid gridOf(const VoxelEvidence& evidence, const FloorHeights& floor, const HeightBand& band) {
    OccupancyGrid grid;
    grid.cell = evidence.cell();
    grid.origin = evidence.origin().head<2>();
    grid.columns = evidence.size().x();
    grid.rows = evidence.size().y();
    grid.cells.resize(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows));
    const EvidenceSettings& odds = evidence.settings();
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns; ++x) {
            const double placeX = grid.origin.x() + (x + 0.5) * grid.cell,
                         placeY = grid.origin.y() + (y + 0.5) * grid.cell;
            const double ground = floor.at(placeX, placeY) - evidence.origin().z();
            const int first = static_cast<int>(std::floor((ground + band.low) / grid.cell + 1e-6)),
                      last = static_cast<int>(std::ceil((ground + band.high) / grid.cell - 1e-6)) - 1;
            int most = 0, least = 0;
            for (int z = first; z <= last; ++z) {
                most = std::max(most, evidence.at(x, y, z));
                least = std::min(least, evidence.at(x, y, z));
            }
            OccupancyGrid::Cell& cell =
                grid.cells[static_cast<std::size_t>(y) * static_cast<std::size_t>(grid.columns) +
                           static_cast<std::size_t>(x)];
            if (most > 0) {
                cell = {OccupancyGrid::State::Occupied,
                        static_cast<float>(most) / static_cast<float>(odds.most)};
            } else if (least < 0) {
                cell = {OccupancyGrid::State::Free,
                        static_cast<float>(least) / static_cast<float>(odds.least)};
            } else if (floor.seen(placeX, placeY)) {
                cell = {OccupancyGrid::State::Free, 0.0F};
            }
        }
    }
    return grid;
}

double exploredArea(const OccupancyGrid& grid) {
    const auto known = std::count_if(
        grid.cells.begin(), grid.cells.end(),
        [](const OccupancyGrid::Cell& cell) { return cell.state != OccupancyGrid::State::Unexplored; });
    return static_cast<double>(known) * grid.cell * grid.cell;
}

}  // namespace leitstand
