#include "robots/control/driving/floor_memory.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace leitstand {
namespace {

constexpr std::int64_t Half = std::int64_t{1} << 30U;
constexpr int HitEvidence = 3, MostEvidence = 6, LeastEvidence = -3;
constexpr std::size_t MostCells = 400'000;  // some 9000 m2
constexpr double Beside = 0.8;              // of the robot: its body hides the ground [m]
constexpr double Escape = 0.6;              // so far it may drive out of where obstacles are too near [m]

std::int64_t keyAt(std::int64_t x, std::int64_t y) {
    return ((x + Half) << 32U) | (y + Half);
}

std::int64_t columnOf(std::int64_t key) {
    return (key >> 32U) - Half;
}

std::int64_t rowOf(std::int64_t key) {
    return (key & 0xFFFFFFFF) - Half;
}

std::int64_t beside(std::int64_t key, std::int64_t x, std::int64_t y) {
    return keyAt(columnOf(key) + x, rowOf(key) + y);
}

}  // namespace

FloorMemory::FloorMemory(const FloorMemorySettings& settings) : m_settings(settings) {
    const double most = std::max(settings.clearance, settings.comfort);
    const int reach = static_cast<int>(std::ceil(most / settings.cell));
    for (int x = -reach; x <= reach; ++x) {
        for (int y = -reach; y <= reach; ++y) {
            if (std::hypot(x, y) * settings.cell <= most) m_disc.emplace_back(x, y);
        }
    }
}

void FloorMemory::clear() {
    m_cells.clear();
    m_here.reset();
}

FloorMemory::Key FloorMemory::keyOf(const Eigen::Vector2d& place) const {
    const auto index = [this](double value) {
        return static_cast<std::int64_t>(std::clamp(std::floor(value / m_settings.cell), -1e8, 1e8));
    };
    return keyAt(index(place.x()), index(place.y()));
}

Eigen::Vector2d FloorMemory::middleOf(Key key) const {
    return {(static_cast<double>(columnOf(key)) + 0.5) * m_settings.cell,
            (static_cast<double>(rowOf(key)) + 0.5) * m_settings.cell};
}

const FloorMemory::Cell* FloorMemory::find(Key key) const {
    const auto cell = m_cells.find(key);
    return cell == m_cells.end() ? nullptr : &cell->second;
}

void FloorMemory::addEvidence(Key key, int evidence) {
    Cell& cell = m_cells[key];
    const bool before = cell.evidence > 0;
    cell.evidence =
        static_cast<std::int8_t>(std::clamp(cell.evidence + evidence, LeastEvidence, MostEvidence));
    const bool after = cell.evidence > 0;
    if (before == after) return;
    for (const Eigen::Vector2i& offset : m_disc) {
        Cell& other = m_cells[beside(key, offset.x(), offset.y())];
        const auto count = [after](std::uint16_t& blocked) {
            blocked = static_cast<std::uint16_t>(after ? blocked + 1 : std::max(0, blocked - 1));
        };
        count(other.close);
        if (offset.cast<double>().norm() * m_settings.cell <= m_settings.clearance) count(other.near);
    }
}

void FloorMemory::seeAlong(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                           const std::unordered_set<Key>& held) {
    const double length = (to - from).norm();
    std::optional<Key> last;
    for (double along = 0.0; along <= length; along += 0.5 * m_settings.cell) {
        const Key key = keyOf(from + (to - from) * (length > 0.0 ? along / length : 0.0));
        if (last == key) continue;
        last = key;
        m_cells[key].seen = true;
        if (!held.contains(key)) addEvidence(key, -1);
    }
}

void FloorMemory::see(const VirtualScanView& view, const Pose& baseInOdom) {
    const Eigen::Vector2d here = baseInOdom.translation().head<2>();
    if (!here.allFinite() || m_cells.size() > MostCells) return;
    const Eigen::Vector3d ahead = baseInOdom.linear().col(0);
    const Eigen::Rotation2Dd turn(std::atan2(ahead.y(), ahead.x()));
    // What the scan still holds for an obstacle beside the wheels, where nobody can look, stays.
    std::unordered_set<Key> held;
    for (const VirtualObstacle& one : view.obstacles) {
        if (one.where.norm() < Beside) held.insert(keyOf(here + turn * one.where));
    }
    for (std::size_t i = 0; i < view.sectors.size(); ++i) {
        const VirtualSector& sector = view.sectors[i];
        if (sector.age > m_settings.maxAge) continue;
        const double direction = view.directionOf(static_cast<int>(i));
        double length = sector.outer ? std::min(sector.outer->norm(), m_settings.sight) : m_settings.sight;
        if (sector.inner) length = std::min(length, sector.inner->norm() - m_settings.cell);
        if (length <= 0.0) continue;
        const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
        seeAlong(here, here + turn * (length * along), held);
    }
    for (const VirtualObstacle& one : view.obstacles) {
        if (one.age <= m_settings.maxAge && one.where.norm() < m_settings.sight + 1.0)
            addEvidence(keyOf(here + turn * one.where), HitEvidence);
    }
    if (m_settings.around > 0.0) {
        for (const Key key : around(here, m_settings.around)) m_cells[key].seen = true;
    }
    const Key key = keyOf(here);
    Cell& cell = m_cells[key];
    cell.seen = true;
    if (m_here != key && cell.visits < 1000) ++cell.visits;
    m_here = key;
}

std::vector<FloorMemory::Key> FloorMemory::around(const Eigen::Vector2d& place, double radius) const {
    const auto reach = static_cast<std::int64_t>(std::ceil(radius / m_settings.cell));
    const Key middle = keyOf(place);
    std::vector<Key> keys;
    for (std::int64_t x = -reach; x <= reach; ++x) {
        for (std::int64_t y = -reach; y <= reach; ++y) {
            const Key key = beside(middle, x, y);
            if ((middleOf(key) - place).norm() <= radius) keys.push_back(key);
        }
    }
    return keys;
}

void FloorMemory::giveUp(const Eigen::Vector2d& place, double radius) {
    for (const Key key : around(place, radius)) m_cells[key].givenUp = true;
}

void FloorMemory::doubt(const Eigen::Vector2d& place, double radius) {
    std::vector<Key> doubted;
    for (auto& [key, cell] : m_cells) {
        cell.givenUp = false;
        // Walls stay: nobody ever looked through them.
        const bool near = (middleOf(key) - place).norm() < radius;
        if (cell.evidence > 0 && (cell.seen || near)) doubted.push_back(key);
    }
    for (const Key key : doubted) addEvidence(key, LeastEvidence - MostEvidence);
}

void FloorMemory::shun(const Eigen::Vector2d& place, double radius) {
    for (const Key key : around(place, radius)) m_cells[key].shunned = true;
}

bool FloorMemory::isBorder(Key key) const {
    const Cell* cell = find(key);
    if (cell == nullptr || !cell->seen || cell->near > 0 || cell->givenUp) return false;
    int unseen = 0;
    for (std::int64_t x = -1; x <= 1; ++x) {
        for (std::int64_t y = -1; y <= 1; ++y) {
            const Cell* other = find(beside(key, x, y));
            if (other == nullptr || (!other->seen && other->evidence <= 0 && !other->givenUp)) ++unseen;
        }
    }
    return unseen >= 2;
}

bool FloorMemory::isBorderNear(const Eigen::Vector2d& place) const {
    const Key key = keyOf(place);
    for (std::int64_t x = -1; x <= 1; ++x) {
        for (std::int64_t y = -1; y <= 1; ++y) {
            if (isBorder(beside(key, x, y))) return true;
        }
    }
    return false;
}

bool FloorMemory::isFreeBetween(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    const double length = (to - from).norm();
    for (double along = 0.0; along <= length; along += 0.5 * m_settings.cell) {
        const Cell* cell = find(keyOf(from + (to - from) * (length > 0.0 ? along / length : 0.0)));
        if (cell == nullptr) continue;
        if (cell->evidence > 0 || ((cell->near > 0 || cell->shunned) && along > 0.3)) return false;
    }
    return true;
}

double FloorMemory::weightOf(const Cell* cell, bool tight) {
    if (cell == nullptr) return 2.5;
    const double narrow = tight ? 6.0 : cell->close > 0 ? 2.0 : 1.0;
    return narrow * (cell->seen ? 1.0 : 2.5) * (cell->shunned ? 4.0 : 1.0);
}

std::vector<Eigen::Vector2d> FloorMemory::search(const Eigen::Vector2d& from,
                                                 const std::function<bool(Key)>& goal,
                                                 std::optional<double> unseen, const Turning& turning) const {
    const auto turned = [&turning, this](std::int64_t x, std::int64_t y) {
        const double towards = std::atan2(static_cast<double>(y), static_cast<double>(x));
        const double turn = std::abs(std::remainder(towards - turning.heading, 2.0 * std::numbers::pi));
        return turning.cost / m_settings.cell * turn / std::numbers::pi;
    };
    struct Node {
        double cost;
        Key key;
        bool operator<(const Node& other) const { return cost > other.cost; }
    };
    struct Best {
        double cost;
        Key before;
        bool closed = false;
    };
    std::priority_queue<Node> open;
    std::unordered_map<Key, Best> best;
    const Key start = keyOf(from);
    open.push({0.0, start});
    best[start] = {0.0, start};
    while (!open.empty() && best.size() < MostCells) {
        const Node node = open.top();
        open.pop();
        Best& mine = best[node.key];
        if (mine.closed) continue;
        mine.closed = true;
        if (goal(node.key)) {
            std::vector<Eigen::Vector2d> way;
            for (Key key = node.key; key != start; key = best[key].before) way.push_back(middleOf(key));
            std::reverse(way.begin(), way.end());
            if (way.empty()) way.push_back(middleOf(start));
            return way;
        }
        for (std::int64_t x = -1; x <= 1; ++x) {
            for (std::int64_t y = -1; y <= 1; ++y) {
                if (x == 0 && y == 0) continue;
                const Key next = beside(node.key, x, y);
                const Cell* cell = find(next);
                if (cell == nullptr || !cell->seen) {
                    if (!unseen || (middleOf(next) - from).norm() > *unseen) continue;
                }
                if (cell != nullptr && cell->evidence > 0) continue;
                const bool tight = cell != nullptr && cell->near > 0;
                if (tight && (middleOf(next) - from).norm() > Escape) continue;
                const double cost = node.cost + weightOf(cell, tight) * std::hypot(x, y) +
                                    (node.key == start ? turned(x, y) : 0.0);
                const auto found = best.find(next);
                if (found != best.end() && found->second.cost <= cost) continue;
                best[next] = {cost, node.key};
                open.push({cost, next});
            }
        }
    }
    return {};
}

std::vector<Eigen::Vector2d> FloorMemory::wayToUnseen(const Eigen::Vector2d& from,
                                                      const Turning& turning) const {
    return search(
        from, [this](Key key) { return isBorder(key); }, std::nullopt, turning);
}

std::vector<Eigen::Vector2d> FloorMemory::wayTo(const Eigen::Vector2d& from, const Eigen::Vector2d& goal,
                                                double near) const {
    const double around = 1.5 * (goal - from).norm() + 6.0;
    const Key wanted = keyOf(goal);
    const Cell* cell = find(wanted);
    if (cell == nullptr || cell->near == 0) {
        auto way = search(from, [wanted](Key key) { return key == wanted; }, around, {});
        if (!way.empty()) return way;
    }
    return search(from, [&](Key key) { return (middleOf(key) - goal).norm() < near; }, around, {});
}

bool FloorMemory::isSeen(const Eigen::Vector2d& place) const {
    const Cell* cell = find(keyOf(place));
    return cell != nullptr && cell->seen;
}

bool FloorMemory::isBlocked(const Eigen::Vector2d& place) const {
    const Cell* cell = find(keyOf(place));
    return cell != nullptr && cell->evidence > 0;
}

int FloorMemory::visits(const Eigen::Vector2d& place) const {
    const Cell* cell = find(keyOf(place));
    return cell != nullptr ? cell->visits : 0;
}

double FloorMemory::seenArea() const {
    const auto seen =
        std::count_if(m_cells.begin(), m_cells.end(), [](const auto& entry) { return entry.second.seen; });
    return static_cast<double>(seen) * m_settings.cell * m_settings.cell;
}

}  // namespace leitstand
