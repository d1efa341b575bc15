#include "core/mapping/placement/correlation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace leitstand {
namespace {

constexpr double Cell = 0.05;  ///< of the table, and step of the search [m]
constexpr double AngleStep = degrees(1);
constexpr int Block = 4;        ///< edge of a block of poses, in cells
constexpr double Sigma = 0.06;  ///< of the likelihood around a wall [m]
constexpr int Kernel = 4;       ///< cells around a wall that have any

/// The likelihood of a wall in each cell around a place, and the largest one in each cell's block.
class Likelihood {
public:
    Likelihood(const WallMap& map, const Eigen::Vector2d& middle, double reach)
        : m_from(middle.array() - reach),
          m_size(static_cast<int>(std::ceil(2.0 * reach / Cell)) + 1),
          m_fine(static_cast<std::size_t>(m_size) * static_cast<std::size_t>(m_size), 0.0F) {
        for (const Eigen::Vector3f& wall : map.walls.points) stamp(wall.head<2>().cast<double>());
        pool();
    }
    [[nodiscard]] Eigen::Vector2i cellOf(const Eigen::Vector2d& point) const {
        return ((point - m_from) / Cell).array().floor().cast<int>();
    }
    [[nodiscard]] float at(int x, int y) const { return inside(x, y) ? m_fine[index(x, y)] : 0.0F; }
    [[nodiscard]] float most(int x, int y) const { return inside(x, y) ? m_most[index(x, y)] : 0.0F; }

private:
    [[nodiscard]] bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < m_size && y < m_size; }
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(m_size) + static_cast<std::size_t>(x);
    }
    void stamp(const Eigen::Vector2d& wall) {
        const Eigen::Vector2i cell = cellOf(wall);
        for (int y = cell.y() - Kernel; y <= cell.y() + Kernel; ++y) {
            for (int x = cell.x() - Kernel; x <= cell.x() + Kernel; ++x) {
                if (!inside(x, y)) continue;
                const Eigen::Vector2d middle = m_from + Cell * Eigen::Vector2d(x + 0.5, y + 0.5);
                const double likely = std::exp(-0.5 * (middle - wall).squaredNorm() / (Sigma * Sigma));
                float& kept = m_fine[index(x, y)];
                kept = std::max(kept, static_cast<float>(likely));
            }
        }
    }
    void pool() {
        std::vector<float> rows(m_fine.size(), 0.0F);
        m_most.assign(m_fine.size(), 0.0F);
        for (int y = 0; y < m_size; ++y) {
            for (int x = 0; x < m_size; ++x) {
                for (int i = 0; i < Block; ++i) rows[index(x, y)] = std::max(rows[index(x, y)], at(x + i, y));
            }
        }
        for (int y = 0; y < m_size; ++y) {
            for (int x = 0; x < m_size; ++x) {
                for (int i = 0; i < Block && y + i < m_size; ++i)
                    m_most[index(x, y)] = std::max(m_most[index(x, y)], rows[index(x, y + i)]);
            }
        }
    }

    Eigen::Vector2d m_from;
    int m_size;
    std::vector<float> m_fine, m_most;
};

struct Candidate {
    double score;
    int x, y;  ///< cells from the guess
    int turn;  ///< steps
};

}  // namespace

Correlation correlate(const LaserView& view, const WallMap& map, const FlatPose& guess,
                      const SearchWindow& window) {
    Correlation found;
    found.pose = guess;
    if (view.points.empty() || map.walls.points.empty()) return found;
    double reach = 0.0;
    for (const Eigen::Vector2f& point : view.points) reach = std::max(reach, double{point.norm()});
    const int most = std::max(1, static_cast<int>(std::lround(window.distance / Cell)));
    const int turns = static_cast<int>(std::lround(window.angle / AngleStep));
    const Likelihood likely(map, guess.place, reach + window.distance + Block * Cell);

    std::vector<std::vector<Eigen::Vector2i>> cells;  // of the view's points, by turn
    for (int turn = -turns; turn <= turns; ++turn) {
        const FlatPose turned{guess.place, guess.heading + turn * AngleStep};
        auto& of = cells.emplace_back();
        for (const Eigen::Vector2f& point : view.points)
            of.push_back(likely.cellOf(turned * point.cast<double>()));
    }
    const auto meanOf = [&](const Candidate& one, auto value) {
        double sum = 0.0;
        const auto& of = cells[static_cast<std::size_t>(one.turn + turns)];
        for (const Eigen::Vector2i& cell : of) sum += double{value(cell.x() + one.x, cell.y() + one.y)};
        return sum / static_cast<double>(of.size());
    };
    std::vector<Candidate> blocks;
    for (int turn = -turns; turn <= turns; ++turn) {
        for (int y = -most; y <= most; y += Block) {
            for (int x = -most; x <= most; x += Block) {
                Candidate block{0.0, x, y, turn};
                block.score = meanOf(block, [&](int cx, int cy) { return likely.most(cx, cy); });
                blocks.push_back(block);
            }
        }
    }
    std::stable_sort(blocks.begin(), blocks.end(),
                     [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
    std::vector<Candidate> seen;
    Candidate best{-1.0, 0, 0, 0};
    for (const Candidate& block : blocks) {
        if (block.score < Correlation::ClearBelow * best.score) break;
        for (int y = block.y; y < block.y + Block && y <= most; ++y) {
            for (int x = block.x; x < block.x + Block && x <= most; ++x) {
                Candidate one{0.0, x, y, block.turn};
                one.score = meanOf(one, [&](int cx, int cy) { return likely.at(cx, cy); });
                if (one.score > best.score) best = one;
                seen.push_back(one);
            }
        }
    }
    found.score = best.score;
    found.pose = {guess.place + Cell * Eigen::Vector2d(best.x, best.y),
                  guess.heading + best.turn * AngleStep};
    found.second = Correlation::ClearBelow * best.score;
    for (const Candidate& one : seen) {
        const double apart = Cell * std::hypot(one.x - best.x, one.y - best.y);
        const bool other = apart > Correlation::Apart ||
                           std::abs(std::remainder((one.turn - best.turn) * AngleStep, 2.0 * M_PI)) >
                               Correlation::TurnedApart;
        if (other) found.second = std::max(found.second, one.score);
    }
    return found;
}

}  // namespace leitstand
