#include "core/mapping/walls/wall_raster.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <queue>

namespace leitstand {
namespace {

constexpr double Sigma = 0.12;  ///< of the likelihood about a wall [m]
constexpr int Kernel = 3;       ///< cells around a wall that have any
constexpr double Border = 2.0;  ///< around all walls [m]

/// A block of poses of one heading.
struct Block {
    float bound = 0.0F;  ///< no pose of it has a better score
    int level = 0;
    int turn = 0;
    int x = 0, y = 0;  ///< cell of its first pose

    /// The best first; equal ones in an order that does not depend on their arrival.
    bool operator<(const Block& other) const {
        if (bound != other.bound) return bound < other.bound;
        if (level != other.level) return level > other.level;
        if (turn != other.turn) return turn > other.turn;
        return y != other.y ? y > other.y : x > other.x;
    }
};

}  // namespace

WallRaster::WallRaster(std::span<const Eigen::Vector2f> walls) {
    Eigen::AlignedBox2d box;
    const auto near = [](const Eigen::Vector2f& wall) {
        return wall.allFinite() && wall.cwiseAbs().maxCoeff() <= static_cast<float>(Farthest);
    };
    for (const Eigen::Vector2f& wall : walls) {
        if (near(wall)) box.extend(wall.cast<double>());
    }
    if (box.isEmpty()) return;
    m_from = box.min().array() - Border;
    const Eigen::Vector2d size = box.sizes().array() + 2.0 * Border;
    m_width = static_cast<int>(std::ceil(size.x() / Cell)) + 1;
    m_height = static_cast<int>(std::ceil(size.y() / Cell)) + 1;
    if (static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height) > MostCells) return;
    m_levels.assign(1, std::vector<std::uint8_t>(
                           static_cast<std::size_t>(m_width) * static_cast<std::size_t>(m_height), 0));
    for (const Eigen::Vector2f& wall : walls) {
        if (near(wall)) stamp(wall.cast<double>());
    }
    pool();
}

Eigen::Vector2i WallRaster::cellOf(const Eigen::Vector2d& point) const {
    return ((point - m_from) / Cell).array().floor().cast<int>();
}

float WallRaster::at(int level, int x, int y) const {
    // A block that begins before the raster may reach into it.
    const int reach = (1 << level) - 1;
    if (x < -reach || y < -reach || x >= m_width || y >= m_height) return 0.0F;
    const auto column = static_cast<std::size_t>(std::max(x, 0)),
               row = static_cast<std::size_t>(std::max(y, 0));
    return static_cast<float>(
        m_levels[static_cast<std::size_t>(level)][row * static_cast<std::size_t>(m_width) + column]);
}

void WallRaster::stamp(const Eigen::Vector2d& wall) {
    const Eigen::Vector2i cell = cellOf(wall);
    for (int y = std::max(0, cell.y() - Kernel); y <= std::min(m_height - 1, cell.y() + Kernel); ++y) {
        for (int x = std::max(0, cell.x() - Kernel); x <= std::min(m_width - 1, cell.x() + Kernel); ++x) {
            const Eigen::Vector2d middle = m_from + Cell * Eigen::Vector2d(x + 0.5, y + 0.5);
            const double likely = std::exp(-0.5 * (middle - wall).squaredNorm() / (Sigma * Sigma));
            auto& kept = m_levels[0][static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                                     static_cast<std::size_t>(x)];
            kept = std::max(kept, static_cast<std::uint8_t>(std::lround(255.0 * likely)));
        }
    }
}

void WallRaster::pool() {
    for (int level = 1; level < Levels; ++level) {
        const std::vector<std::uint8_t>& below = m_levels.back();
        std::vector<std::uint8_t> blocks(below.size());
        const int half = 1 << (level - 1);
        const auto value = [&](int x, int y) {
            if (x >= m_width || y >= m_height) return std::uint8_t{0};
            return below[static_cast<std::size_t>(y) * static_cast<std::size_t>(m_width) +
                         static_cast<std::size_t>(x)];
        };
        std::size_t i = 0;
        for (int y = 0; y < m_height; ++y) {
            for (int x = 0; x < m_width; ++x) {
                blocks[i++] = std::max(std::max(value(x, y), value(x + half, y)),
                                       std::max(value(x, y + half), value(x + half, y + half)));
            }
        }
        m_levels.push_back(std::move(blocks));
    }
}

double WallRaster::scoreAt(std::span<const Eigen::Vector2f> view, const FlatPose& pose) const {
    if (m_levels.empty() || view.empty()) return 0.0;
    double sum = 0.0;
    for (const Eigen::Vector2f& point : view) {
        const Eigen::Vector2i cell = cellOf(pose * point.cast<double>());
        sum += double{at(0, cell.x(), cell.y())};
    }
    return sum / (255.0 * static_cast<double>(view.size()));
}

RasterPlaces WallRaster::find(std::span<const Eigen::Vector2f> view, const RasterSearch& search,
                              const Progress& progress) const {
    constexpr std::size_t MostBlocks = 4'000'000;  // that wait at once
    RasterPlaces result;
    std::vector<RasterPlace>& found = result.places;
    if (m_levels.empty() || view.empty()) return result;
    const int turns = std::max(1, static_cast<int>(std::lround(2.0 * std::numbers::pi / search.angleStep)));
    const double step = 2.0 * std::numbers::pi / turns;
    std::vector<std::vector<Eigen::Vector2i>> cells(static_cast<std::size_t>(turns));  // of the view, by turn
    for (int turn = 0; turn < turns; ++turn) {
        const Eigen::Rotation2Dd turned(turn * step);
        auto& of = cells[static_cast<std::size_t>(turn)];
        for (const Eigen::Vector2f& point : view)
            of.push_back(((turned * point.cast<double>()) / Cell).array().round().cast<int>());
    }
    const auto boundOf = [&](Block block) {
        float sum = 0.0F;
        for (const Eigen::Vector2i& cell : cells[static_cast<std::size_t>(block.turn)])
            sum += at(block.level, block.x + cell.x(), block.y + cell.y());
        block.bound = sum / (255.0F * static_cast<float>(view.size()));
        return block;
    };
    const auto placeOf = [&](const Block& block) {
        const double half = 0.5 * (1 << block.level);
        return Eigen::Vector2d(m_from + Cell * Eigen::Vector2d(block.x + half, block.y + half));
    };
    std::priority_queue<Block> waiting;
    const auto leastNow = [&] {
        return found.empty() ? search.leastScore
                             : std::max(search.leastScore, search.likeBest * found.front().score);
    };
    constexpr int Top = Levels - 1, Side = 1 << Top;
    for (int turn = 0; turn < turns; ++turn) {
        if (progress.cancelled()) return result;
        for (int y = 0; y < m_height; y += Side) {
            for (int x = 0; x < m_width; x += Side) {
                const Block block = boundOf({0.0F, Top, turn, x, y});
                if (block.bound >= search.leastScore) waiting.push(block);
            }
        }
    }
    for (std::size_t looked = 0; !waiting.empty(); ++looked) {
        const Block block = waiting.top();
        const bool enough = static_cast<int>(found.size()) >= search.most || waiting.size() > MostBlocks;
        if (block.bound < leastNow() || enough || (looked % 1'024 == 0 && progress.cancelled())) {
            result.others = double{block.bound};
            break;
        }
        waiting.pop();
        const double within = 0.5 * std::sqrt(2.0) * Cell * ((1 << block.level) - 1);  // its farthest pose
        const bool known = std::any_of(found.begin(), found.end(), [&](const RasterPlace& place) {
            const double turned =
                std::remainder(block.turn * step - place.pose.heading, 2.0 * std::numbers::pi);
            return (placeOf(block) - place.pose.place).norm() + within < search.apart &&
                   std::abs(turned) < search.turnedApart;
        });
        if (known) continue;
        if (block.level == 0) {
            found.push_back({{placeOf(block), block.turn * step}, block.bound});
            continue;
        }
        const int half = 1 << (block.level - 1);
        for (const int y : {block.y, block.y + half}) {
            for (const int x : {block.x, block.x + half}) {
                const Block part = boundOf({0.0F, block.level - 1, block.turn, x, y});
                if (part.bound >= leastNow()) waiting.push(part);
            }
        }
    }
    return result;
}

std::vector<RasterPlace> WallRaster::beside(std::span<const Eigen::Vector2f> view, const FlatPose& best,
                                            const Eigen::Vector2d& about, double within, double alike) const {
    constexpr double Between = 0.8;  // largest share of a place's score, somewhere on the way to the best one
    const auto steps = static_cast<int>(std::ceil(within / Cell));
    const int side = 2 * steps + 1;
    const auto poseOf = [&](int x, int y) {
        return FlatPose{about + Cell * Eigen::Vector2d(x - steps, y - steps), best.heading};
    };
    std::vector<double> scores;
    scores.reserve(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) scores.push_back(scoreAt(view, poseOf(x, y)));
    }
    const auto scoreOf = [&](int x, int y) {
        const bool inside = x >= 0 && y >= 0 && x < side && y < side;
        return inside ? scores[static_cast<std::size_t>(y * side + x)] : 0.0;
    };
    /// Returns whether no neighbour has a better score.
    const auto isPeak = [&](int x, int y) {
        for (const int dy : {-1, 0, 1}) {
            for (const int dx : {-1, 0, 1}) {
                if (scoreOf(x + dx, y + dy) > scoreOf(x, y)) return false;
            }
        }
        return true;
    };
    const auto isParted = [&](const RasterPlace& place) {
        const Eigen::Vector2d way = place.pose.place - best.place;
        const auto parts = static_cast<int>(std::ceil(way.norm() / Cell));
        for (int i = 1; i < parts; ++i) {
            const FlatPose there{best.place + way * i / parts, best.heading};
            if (scoreAt(view, there) < Between * place.score) return true;
        }
        return false;
    };
    std::vector<RasterPlace> places;
    const double least = alike * scoreAt(view, best);
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const RasterPlace place{poseOf(x, y), scoreOf(x, y)};
            const bool near = (place.pose.place - about).norm() <= within;
            const bool other = (place.pose.place - best.place).norm() >= PlacesApart;
            if (near && other && place.score >= least && isPeak(x, y) && isParted(place))
                places.push_back(place);
        }
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const RasterPlace& a, const RasterPlace& b) { return a.score > b.score; });
    std::vector<RasterPlace> kept;
    for (const RasterPlace& place : places) {
        const bool known = std::any_of(kept.begin(), kept.end(), [&](const RasterPlace& one) {
            return (one.pose.place - place.pose.place).norm() < PlacesApart;
        });
        if (!known) kept.push_back(place);
    }
    return kept;
}

}  // namespace leitstand
