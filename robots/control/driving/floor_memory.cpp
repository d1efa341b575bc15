#include "robots/control/driving/floor_memory.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace leitstand {
namespace {

constexpr int HitEvidence = 3, MostEvidence = 6, LeastEvidence = -3;
constexpr std::size_t MostCells = 400'000;  ///< some 9000 m2
constexpr double Beside = 0.8;              ///< so near the robot, its body hides the ground [m]
constexpr double Escape = 0.6;              ///< so far it may drive to leave a place too near obstacles [m]
constexpr double SameFloor = 1.2;           ///< heights of one floor differ less (storeys: 2 m at least) [m]
constexpr double MostRise = 0.5;            ///< of the seen floor, by the tilt of the robot [m]

// A key: three bits for the floor, 30 for each coordinate of the square.
constexpr int Bits = 30;
constexpr std::int64_t Half = std::int64_t{1} << (Bits - 1), Mask = (std::int64_t{1} << Bits) - 1;
constexpr std::int64_t Floor = std::int64_t{1} << (2 * Bits);  // step to the next floor of the same square
constexpr int MostFloors = 8;

std::int64_t keyAt(std::int64_t x, std::int64_t y) {
    return (((x + Half) & Mask) << Bits) | ((y + Half) & Mask);
}

std::int64_t columnOf(std::int64_t key) {
    return ((key >> Bits) & Mask) - Half;
}

std::int64_t rowOf(std::int64_t key) {
    return (key & Mask) - Half;
}

/// Returns the square at an offset from that of @p key.
std::int64_t beside(std::int64_t key, std::int64_t x, std::int64_t y) {
    return keyAt(columnOf(key) + x, rowOf(key) + y);
}

std::int64_t squareOfKey(std::int64_t key) {
    return key % Floor;
}

/// The plane that a robot stands on, extended around it with a bounded rise.
class Ground {
public:
    explicit Ground(const Pose& baseInOdom)
        : m_at(baseInOdom.translation()), m_up(baseInOdom.linear().col(2)) {}
    [[nodiscard]] Eigen::Vector3d at(const Eigen::Vector2d& place) const {
        const double rise = -m_up.head<2>().dot(place - m_at.head<2>()) / std::max(m_up.z(), 0.5);
        return {place.x(), place.y(), m_at.z() + std::clamp(rise, -MostRise, MostRise)};
    }

private:
    Eigen::Vector3d m_at, m_up;
};

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

bool FloorMemory::isSameFloor(double one, double other) {
    return std::abs(one - other) < SameFloor;
}

FloorMemory::Key FloorMemory::squareOf(const Eigen::Vector2d& place) const {
    const auto index = [this](double value) {
        return static_cast<std::int64_t>(std::clamp(std::floor(value / m_settings.cell), -1e8, 1e8));
    };
    return keyAt(index(place.x()), index(place.y()));
}

Eigen::Vector2d FloorMemory::middleOf(Key key) const {
    return {(static_cast<double>(columnOf(key)) + 0.5) * m_settings.cell,
            (static_cast<double>(rowOf(key)) + 0.5) * m_settings.cell};
}

FloorMemory::Place FloorMemory::find(Key square, double height) const {
    Place nearest{square, nullptr};
    const auto off = [height](const Cell& cell) { return std::abs(cell.height - height); };
    for (int floor = 0; floor < MostFloors; ++floor) {
        const Key key = square + floor * Floor;
        const auto cell = m_cells.find(key);
        if (cell == m_cells.end()) {
            if (nearest.cell == nullptr) nearest.key = key;  // a new floor goes there
            break;
        }
        if (!isSameFloor(cell->second.height, height)) continue;
        if (nearest.cell == nullptr || off(cell->second) < off(*nearest.cell)) nearest = {key, &cell->second};
    }
    return nearest;
}

std::pair<FloorMemory::Key, FloorMemory::Cell*> FloorMemory::at(Key square, double height) {
    const Key key = find(square, height).key;  // the lowest floor's when there is no room for another
    const auto [cell, isNew] = m_cells.try_emplace(key);
    if (isNew) cell->second.height = static_cast<float>(height);
    return {key, &cell->second};
}

void FloorMemory::addEvidence(Key square, double height, int evidence) {
    Cell& cell = *at(square, height).second;
    const bool before = cell.evidence > 0;
    cell.evidence =
        static_cast<std::int8_t>(std::clamp(cell.evidence + evidence, LeastEvidence, MostEvidence));
    const bool after = cell.evidence > 0;
    if (before == after) return;
    const double floor = cell.height;
    for (const Eigen::Vector2i& offset : m_disc) {
        Cell& other = *at(beside(square, offset.x(), offset.y()), floor).second;
        const auto count = [after](std::uint16_t& blocked) {
            blocked = static_cast<std::uint16_t>(after ? blocked + 1 : std::max(0, blocked - 1));
        };
        count(other.close);
        if (offset.cast<double>().norm() * m_settings.cell <= m_settings.clearance) count(other.near);
    }
}

void FloorMemory::seeAlong(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                           const std::unordered_set<Key>& held) {
    const double length = (to - from).head<2>().norm();
    std::optional<Key> last;
    for (double along = 0.0; along <= length; along += 0.5 * m_settings.cell) {
        const Eigen::Vector3d place = from + (to - from) * (length > 0.0 ? along / length : 0.0);
        const Key square = squareOf(place.head<2>());
        if (last == square) continue;
        last = square;
        Cell& cell = *at(square, place.z()).second;
        cell.seen = true;
        cell.height = static_cast<float>(place.z());
        // A square that is known to be free does not change.
        if (!held.contains(square) && cell.evidence > LeastEvidence) addEvidence(square, place.z(), -1);
    }
}

void FloorMemory::see(const VirtualScanView& view, const Pose& baseInOdom) {
    const Eigen::Vector3d at = baseInOdom.translation();
    if (!at.allFinite() || m_cells.size() > MostCells) return;
    const Eigen::Vector2d here = at.head<2>();
    const Ground ground(baseInOdom);
    const Eigen::Vector3d ahead = baseInOdom.linear().col(0);
    const Eigen::Rotation2Dd turn(std::atan2(ahead.y(), ahead.x()));
    // Obstacles that the scan still has beside the wheels, where it cannot see, stay.
    std::unordered_set<Key> held;
    for (const VirtualObstacle& one : view.obstacles) {
        if (one.where.norm() < Beside) held.insert(squareOf(here + turn * one.where));
    }
    for (std::size_t i = 0; i < view.sectors.size(); ++i) {
        const VirtualSector& sector = view.sectors[i];
        if (sector.age > m_settings.maxAge) continue;
        const double direction = view.directionOf(static_cast<int>(i));
        double length = sector.outer ? std::min(sector.outer->norm(), m_settings.sight) : m_settings.sight;
        if (sector.inner) length = std::min(length, sector.inner->norm() - m_settings.cell);
        if (length <= 0.0) continue;
        const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
        seeAlong(at, ground.at(here + turn * (length * along)), held);
    }
    for (const VirtualObstacle& one : view.obstacles) {
        const Eigen::Vector3d place = ground.at(here + turn * one.where);
        if (one.age <= m_settings.maxAge && one.where.norm() < m_settings.sight + 1.0)
            addEvidence(squareOf(place.head<2>()), place.z(), HitEvidence);
    }
    if (m_settings.around > 0.0) {
        for (const Key square : squaresAround(here, m_settings.around))
            this->at(square, at.z()).second->seen = true;
    }
    const auto [key, cell] = this->at(squareOf(here), at.z());
    cell->seen = true;
    cell->height = static_cast<float>(at.z());
    if (m_here != key && cell->visits < 1000) ++cell->visits;
    m_here = key;
}

std::vector<FloorMemory::Key> FloorMemory::squaresAround(const Eigen::Vector2d& place, double radius) const {
    const auto reach = static_cast<std::int64_t>(std::ceil(radius / m_settings.cell));
    const Key middle = squareOf(place);
    std::vector<Key> squares;
    for (std::int64_t x = -reach; x <= reach; ++x) {
        for (std::int64_t y = -reach; y <= reach; ++y) {
            const Key square = beside(middle, x, y);
            if ((middleOf(square) - place).norm() <= radius) squares.push_back(square);
        }
    }
    return squares;
}

void FloorMemory::giveUp(const Eigen::Vector3d& place, double radius) {
    for (const Key square : squaresAround(place.head<2>(), radius))
        at(square, place.z()).second->givenUp = true;
}

void FloorMemory::doubt(const Eigen::Vector3d& place, double radius) {
    std::vector<std::pair<Key, double>> doubted;
    for (auto& [key, cell] : m_cells) {
        cell.givenUp = false;
        // Walls stay: no scan ever saw through them.
        const bool near =
            (middleOf(key) - place.head<2>()).norm() < radius && isSameFloor(cell.height, place.z());
        if (cell.evidence > 0 && (cell.seen || near)) doubted.emplace_back(squareOfKey(key), cell.height);
    }
    for (const auto& [square, height] : doubted) addEvidence(square, height, LeastEvidence - MostEvidence);
}

void FloorMemory::shun(const Eigen::Vector3d& place, double radius) {
    for (const Key square : squaresAround(place.head<2>(), radius))
        at(square, place.z()).second->shunned = true;
}

bool FloorMemory::isBorder(const Place& place) const {
    const Cell* cell = place.cell;
    if (cell == nullptr || !cell->seen || cell->near > 0 || cell->givenUp) return false;
    int unseen = 0;
    for (std::int64_t x = -1; x <= 1; ++x) {
        for (std::int64_t y = -1; y <= 1; ++y) {
            const Cell* other = find(beside(place.key, x, y), cell->height).cell;
            if (other == nullptr || (!other->seen && other->evidence <= 0 && !other->givenUp)) ++unseen;
        }
    }
    return unseen >= 2;
}

bool FloorMemory::isBorderNear(const Eigen::Vector3d& place) const {
    const Key square = squareOf(place.head<2>());
    for (std::int64_t x = -1; x <= 1; ++x) {
        for (std::int64_t y = -1; y <= 1; ++y) {
            if (isBorder(find(beside(square, x, y), place.z()))) return true;
        }
    }
    return false;
}

bool FloorMemory::isFreeBetween(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const double length = (to - from).head<2>().norm();
    for (double along = 0.0; along <= length; along += 0.5 * m_settings.cell) {
        const Cell* cell = find(from + (to - from) * (length > 0.0 ? along / length : 0.0)).cell;
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

std::vector<Eigen::Vector3d> FloorMemory::search(const Eigen::Vector3d& from, const Goal& goal,
                                                 const Turning& turning) const {
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
        double height;
        bool closed = false;
    };
    std::priority_queue<Node> open;
    std::unordered_map<Key, Best> best;
    const Key start = find(from).key;
    open.push({0.0, start});
    best[start] = {0.0, start, from.z()};
    while (!open.empty() && best.size() < MostCells) {
        const Node node = open.top();
        open.pop();
        Best& mine = best[node.key];
        if (mine.closed) continue;
        mine.closed = true;
        const double height = mine.height;
        const auto known = m_cells.find(node.key);
        if (goal.reached({node.key, known == m_cells.end() ? nullptr : &known->second}, height)) {
            std::vector<Eigen::Vector3d> way;
            const auto add = [&](Key key) {
                const Eigen::Vector2d middle = middleOf(key);
                way.emplace_back(middle.x(), middle.y(), best[key].height);
            };
            for (Key key = node.key; key != start; key = best[key].before) add(key);
            std::reverse(way.begin(), way.end());
            if (way.empty()) add(start);
            return way;
        }
        for (std::int64_t x = -1; x <= 1; ++x) {
            for (std::int64_t y = -1; y <= 1; ++y) {
                if (x == 0 && y == 0) continue;
                const auto [next, cell] = find(beside(node.key, x, y), height);
                const double away = (middleOf(next) - from.head<2>()).norm();
                if ((cell == nullptr || !cell->seen) && (!goal.unseen || away > *goal.unseen)) continue;
                if (cell != nullptr && cell->evidence > 0) continue;
                const bool tight = cell != nullptr && cell->near > 0;
                if (tight && away > Escape) continue;
                const double cost = node.cost + weightOf(cell, tight) * std::hypot(x, y) +
                                    (node.key == start ? turned(x, y) : 0.0);
                const auto found = best.find(next);
                if (found != best.end() && found->second.cost <= cost) continue;
                best[next] = {cost, node.key, cell != nullptr ? cell->height : height};
                open.push({cost, next});
            }
        }
    }
    return {};
}

std::vector<Eigen::Vector3d> FloorMemory::wayToUnseen(const Eigen::Vector3d& from,
                                                      const Turning& turning) const {
    return search(from, {[this](const Place& place, double) { return isBorder(place); }, std::nullopt},
                  turning);
}

std::vector<Eigen::Vector3d> FloorMemory::wayTo(const Eigen::Vector3d& from, const Eigen::Vector3d& goal,
                                                double near) const {
    const double around = 1.5 * (goal - from).head<2>().norm() + 6.0;
    const Place wanted = find(goal);
    // The height of unseen floor shows on the way there: it may be up a ramp.
    const auto isLevel = [&](const Place& place, double height) {
        return place.cell == nullptr || isSameFloor(height, goal.z());
    };
    if (wanted.cell == nullptr || wanted.cell->near == 0) {
        const auto isThere = [&](const Place& place, double height) {
            return place.key == wanted.key && isLevel(place, height);
        };
        auto way = search(from, {isThere, around}, {});
        if (!way.empty()) return way;
    }
    const auto isNear = [&](const Place& place, double height) {
        return (middleOf(place.key) - goal.head<2>()).norm() < near && isSameFloor(height, goal.z());
    };
    return search(from, {isNear, around}, {});
}

bool FloorMemory::isSeen(const Eigen::Vector3d& place) const {
    const Cell* cell = find(place).cell;
    return cell != nullptr && cell->seen;
}

bool FloorMemory::isBlocked(const Eigen::Vector3d& place) const {
    const Cell* cell = find(place).cell;
    return cell != nullptr && cell->evidence > 0;
}

int FloorMemory::visits(const Eigen::Vector3d& place) const {
    const Cell* cell = find(place).cell;
    return cell != nullptr ? cell->visits : 0;
}

double FloorMemory::seenArea() const {
    const auto seen =
        std::count_if(m_cells.begin(), m_cells.end(), [](const auto& entry) { return entry.second.seen; });
    return static_cast<double>(seen) * m_settings.cell * m_settings.cell;
}

}  // namespace leitstand
