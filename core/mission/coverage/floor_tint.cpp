#include "core/mission/coverage/floor_tint.h"

#include <cmath>

namespace leitstand {
namespace {

constexpr float Level = 0.05F;  // [m]

}  // namespace

FloorTint floorTintOf(const CoverageMap& coverage, SearchSensor sensor) {
    const SearchGround& ground = coverage.ground();
    FloorTint tint;
    tint.sensor = sensor;
    const auto half = static_cast<float>(ground.cell() / 2);
    const Eigen::Vector2f corner(half, half);
    std::vector<std::size_t> above;  // patches that end at the row before, from left to right
    for (int row = 0; row < ground.rows(); ++row) {
        std::vector<std::size_t> here;
        std::size_t next = 0;  // index into above
        for (int column = 0; column < ground.columns();) {
            const auto at = [&](int x) { return static_cast<std::size_t>(row * ground.columns() + x); };
            const std::size_t first = at(column);
            if (!ground.isReachable(first)) {
                ++column;
                continue;
            }
            FloorPatch patch;
            patch.seen = coverage.seen(sensor, first);
            patch.height = ground.height(first);
            int end = column + 1;
            while (end < ground.columns() && ground.isReachable(at(end)) &&
                   coverage.seen(sensor, at(end)) == patch.seen &&
                   std::abs(ground.height(at(end)) - patch.height) < Level)
                ++end;
            patch.low = ground.middleOf(first).cast<float>() - corner;
            patch.high = ground.middleOf(at(end - 1)).cast<float>() + corner;
            column = end;
            while (next < above.size() && tint.patches[above[next]].low.x() < patch.low.x() - half) ++next;
            FloorPatch* const known = next < above.size() ? &tint.patches[above[next]] : nullptr;
            if (known != nullptr && known->seen == patch.seen &&
                std::abs(known->low.x() - patch.low.x()) < half &&
                std::abs(known->high.x() - patch.high.x()) < half &&
                std::abs(known->height - patch.height) < Level) {
                known->high.y() = patch.high.y();
                here.push_back(above[next]);
            } else {
                here.push_back(tint.patches.size());
                tint.patches.push_back(patch);
            }
        }
        above = std::move(here);
    }
    return tint;
}

}  // namespace leitstand
