#include "core/mission/coverage/missed_floor.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace leitstand {
namespace {

MissedRegion regionOf(const SearchGround& ground, const std::vector<std::size_t>& cells) {
    MissedRegion region;
    region.area = static_cast<double>(cells.size()) * ground.cell() * ground.cell();
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    region.low = region.high = ground.middleOf(cells.front());
    for (const std::size_t cell : cells) {
        const Eigen::Vector2d at = ground.middleOf(cell);
        sum += at;
        region.low = region.low.cwiseMin(at);
        region.high = region.high.cwiseMax(at);
    }
    const Eigen::Vector2d middle = sum / static_cast<double>(cells.size()),
                          half = Eigen::Vector2d::Constant(ground.cell() / 2);
    region.low -= half;
    region.high += half;
    // The middle of a bent region may lie outside it.
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t cell : cells) {
        const double away = (ground.middleOf(cell) - middle).squaredNorm();
        if (away >= nearest) continue;
        nearest = away;
        region.place = ground.middleOf(cell);
        region.height = static_cast<double>(ground.height(cell));
    }
    return region;
}

std::vector<MissedRegion> largestFirst(std::vector<MissedRegion> regions) {
    std::stable_sort(regions.begin(), regions.end(),
                     [](const MissedRegion& a, const MissedRegion& b) { return a.area > b.area; });
    return regions;
}

}  // namespace

std::vector<MissedRegion> missed(const CoverageMap& coverage, SearchSensor sensor) {
    const SearchGround& ground = coverage.ground();
    std::vector<std::uint8_t> open(ground.size());
    for (std::size_t cell = 0; cell < open.size(); ++cell)
        open[cell] = ground.isReachable(cell) && !coverage.seen(sensor, cell) ? 1 : 0;
    std::vector<MissedRegion> regions;
    for (std::size_t seed = 0; seed < open.size(); ++seed) {
        if (open[seed] == 0) continue;
        std::vector<std::size_t> cells = {seed};
        open[seed] = 0;
        for (std::size_t next = 0; next < cells.size(); ++next) {
            const int row = static_cast<int>(cells[next]) / ground.columns(),
                      column = static_cast<int>(cells[next]) % ground.columns();
            for (const auto& [x, y] : {std::pair{column - 1, row}, std::pair{column + 1, row},
                                       std::pair{column, row - 1}, std::pair{column, row + 1}}) {
                if (x < 0 || y < 0 || x >= ground.columns() || y >= ground.rows()) continue;
                const auto cell = static_cast<std::size_t>(y * ground.columns() + x);
                if (open[cell] == 0) continue;
                open[cell] = 0;
                cells.push_back(cell);
            }
        }
        MissedRegion region = regionOf(ground, cells);
        if (region.area >= coverage.settings().leastMissed) regions.push_back(region);
    }
    return largestFirst(std::move(regions));
}

std::vector<MissedRegion> missed(std::span<const StoreyCoverage> storeys, SearchSensor sensor) {
    std::vector<MissedRegion> all;
    for (const StoreyCoverage& one : storeys) {
        for (MissedRegion region : missed(*one.map, sensor)) {
            region.storey = one.storey.number;
            all.push_back(region);
        }
    }
    return largestFirst(std::move(all));
}

}  // namespace leitstand
