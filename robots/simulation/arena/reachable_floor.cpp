#include "robots/simulation/arena/reachable_floor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/event/all_samples.h"

namespace leitstand::simulation {
namespace {

constexpr double Overhead = 0.6;     ///< robots drive under what hangs higher [m]
constexpr double VictimReach = 0.7;  ///< greatest distance of the floor from a victim's side [m]
constexpr double Storey = 1.5;       ///< least height between floors that lie above each other [m]
constexpr double Sunk = 0.1;         ///< what stands so far below a storey's floor still belongs to it [m]
constexpr double Nothing = std::numeric_limits<double>::quiet_NaN();

/// Returns the heights of an arena's storeys, lowest first [m].
std::vector<double> levelsOf(const Arena& arena) {
    std::vector<double> tops;
    for (const Element& element : arena.elements) {
        if (element.kind == ElementKind::Floor) tops.push_back(element.pose.translation().z());
    }
    std::sort(tops.begin(), tops.end());
    std::vector<double> levels = {0.0};
    for (const double top : tops) {
        if (top >= levels.back() + Storey) levels.push_back(top);
    }
    return levels;
}

/// Heights and obstacles of a storey on a grid.
class Ground {
public:
    /// Takes the elements that stand from height @p from up to below @p to [m]. Above the ground storey,
    /// there is floor only where an element provides it.
    Ground(const Arena& arena, double cell, double level, double from, double to)
        : m_from(arena.from),
          m_cell(cell),
          m_level(level),
          columns(static_cast<int>(std::ceil((arena.to.x() - arena.from.x()) / cell - 1e-9))),
          rows(static_cast<int>(std::ceil((arena.to.y() - arena.from.y()) / cell - 1e-9))),
          height(static_cast<std::size_t>(std::max(0, columns) * std::max(0, rows)),
                 level > 0.0 ? Nothing : 0.0),
          blocked(height.size(), 0),
          open(height.size(), 0) {
        for (const Element& element : arena.elements) {
            const double base = element.pose.translation().z();
            if (base >= from && base < to) add(element);
        }
    }
    /// Fills squares without floor from the storey @p below, which shows through.
    void lookThrough(const Ground& below) {
        for (std::size_t square = 0; square < height.size(); ++square) {
            if (!std::isnan(height[square])) continue;
            open[square] = 1;
            height[square] = below.height[square];
            if (below.blocked[square] != 0) blocked[square] = 1;
        }
    }

    [[nodiscard]] std::size_t place(int column, int row) const {
        return static_cast<std::size_t>(row * columns + column);
    }

private:
    /// Calls visit(square, point in the frame) for all squares under the box between two corners in @p frame.
    template <class Visit>
    void eachUnder(const Pose& frame, const Eigen::Vector2d& low, const Eigen::Vector2d& high,
                   const Visit& visit) {
        Eigen::AlignedBox2d bounds;
        for (const double x : {low.x(), high.x()}) {
            for (const double y : {low.y(), high.y()})
                bounds.extend((frame * Eigen::Vector3d(x, y, 0.0)).head<2>());
        }
        const auto first = [&](double at, double from, int count) {
            return std::clamp(static_cast<int>(std::floor((at - from) / m_cell)), 0, count);
        };
        const Pose back = frame.inverse();
        const double edge = m_cell / 2;  // a thin wall must not fall between the middles of squares
        for (int row = first(bounds.min().y(), m_from.y(), rows);
             row < std::min(rows, first(bounds.max().y(), m_from.y(), rows) + 1); ++row) {
            for (int column = first(bounds.min().x(), m_from.x(), columns);
                 column < std::min(columns, first(bounds.max().x(), m_from.x(), columns) + 1); ++column) {
                const Eigen::Vector3d middle(m_from.x() + (column + 0.5) * m_cell,
                                             m_from.y() + (row + 0.5) * m_cell, frame.translation().z());
                const Eigen::Vector2d inFrame = (back * middle).head<2>();
                if ((inFrame - low).minCoeff() < -edge || (high - inFrame).minCoeff() < -edge) continue;
                visit(place(column, row), inFrame);
            }
        }
    }
    void block(const Pose& frame, const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
        eachUnder(frame, low, high, [&](std::size_t square, const Eigen::Vector2d&) { blocked[square] = 1; });
    }
    template <class Height>
    void raise(const Element& element, const Height& heightAt) {
        const Eigen::Vector2d half = element.size.head<2>() / 2;
        const double base = element.pose.translation().z();
        eachUnder(element.pose, -half, half, [&](std::size_t square, const Eigen::Vector2d& at) {
            height[square] = std::fmax(height[square], base + heightAt(at.cwiseMax(-half).cwiseMin(half)));
        });
    }

    void add(const Element& element) {
        const Eigen::Vector2d half = element.size.head<2>() / 2;
        const Eigen::Vector3d& size = element.size;
        switch (element.kind) {
            case ElementKind::Floor:
                return raise(element, [](const Eigen::Vector2d&) { return 0.0; });
            case ElementKind::Ramp:
                return raise(element,
                             [&](const Eigen::Vector2d& at) { return size.z() * (at.x() / size.x() + 0.5); });
            case ElementKind::Stairs: {
                const double steps = std::max(1.0, std::round(size.z() / std::max(0.005, element.riser)));
                return raise(element, [&, steps](const Eigen::Vector2d& at) {
                    return size.z() / steps *
                           std::min(steps, std::floor((at.x() / size.x() + 0.5) * steps) + 1.0);
                });
            }
            case ElementKind::StepField: {
                const int across = static_cast<int>(std::lround(size.x() / element.cell));
                return raise(element, [&, across](const Eigen::Vector2d& at) {
                    const int column =
                        std::clamp(static_cast<int>((at.x() + half.x()) / element.cell), 0, across - 1);
                    const int row = std::max(0, static_cast<int>((at.y() + half.y() - 1e-9) / element.cell));
                    const auto index = static_cast<std::size_t>(row * across + column);
                    return index < element.heights.size() ? element.heights[index] : 0.0;
                });
            }
            case ElementKind::Door: {
                const double opening = std::min(element.width / 2, half.x());
                block(element.pose, -half, {-opening, half.y()});
                block(element.pose, {opening, -half.y()}, half);
                Pose hinge = element.pose;
                hinge.translate(Eigen::Vector3d(-opening, 0.0, 0.0));
                hinge.rotate(Eigen::AngleAxisd(element.angle, Eigen::Vector3d::UnitZ()));
                return block(hinge, {0.0, -0.02}, {2 * opening, 0.02});
            }
            case ElementKind::Wall:
            case ElementKind::Ceiling:
            case ElementKind::Lamp:
            case ElementKind::Heater:
            case ElementKind::Table:
            case ElementKind::Chair:
            case ElementKind::Overhang:
            case ElementKind::Rubble:
                if (element.pose.translation().z() < std::fmax(height[middleOf(element)], m_level) + Overhead)
                    block(element.pose, -half, half);
                return;
            case ElementKind::Victim: {
                const bool boxed = element.victim && element.victim->situation >= Situation::Void;
                const Eigen::Vector2d margin = Eigen::Vector2d::Constant(boxed ? 0.06 : 0.0);
                return block(element.pose, -half - margin, half + margin);
            }
            case ElementKind::Curtain:
            case ElementKind::LoosePaper:
            case ElementKind::Foil:
            case ElementKind::Sign:
            case ElementKind::Spectator:
            case ElementKind::Smoke:
                return;  // soft, on walls, or outside
        }
    }
    [[nodiscard]] std::size_t middleOf(const Element& element) const {
        const Eigen::Vector3d at = element.pose.translation();
        return place(std::clamp(static_cast<int>((at.x() - m_from.x()) / m_cell), 0, columns - 1),
                     std::clamp(static_cast<int>((at.y() - m_from.y()) / m_cell), 0, rows - 1));
    }

    Eigen::Vector2d m_from;
    double m_cell, m_level;

public:
    int columns, rows;
    std::vector<double> height;
    std::vector<char> blocked;
    std::vector<char> open;  ///< what shows there belongs to the storey below
};

constexpr std::array<std::array<int, 2>, 4> Neighbours = {{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};

/// Returns for each square whether the middle of a robot may be there.
std::vector<char> freeFor(const Ground& ground, double cell, double radius, double maxStep) {
    std::vector<char> edge = ground.blocked;
    const auto inside = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < ground.columns && y < ground.rows;
    };
    for (int y = 0; y < ground.rows; ++y) {
        for (int x = 0; x < ground.columns; ++x) {
            for (const auto& [dx, dy] : Neighbours) {
                if (!inside(x + dx, y + dy)) continue;
                const double rise =
                    ground.height[ground.place(x + dx, y + dy)] - ground.height[ground.place(x, y)];
                if (rise > maxStep) edge[ground.place(x + dx, y + dy)] = 1;
            }
        }
    }
    const int reach = static_cast<int>(std::ceil(radius / cell));
    std::vector<char> free(edge.size(), 1);
    for (int y = 0; y < ground.rows; ++y) {
        for (int x = 0; x < ground.columns; ++x) {
            if (edge[ground.place(x, y)] == 0) continue;
            for (int dy = -reach; dy <= reach; ++dy) {
                for (int dx = -reach; dx <= reach; ++dx) {
                    if (std::hypot(dx, dy) * cell > radius || !inside(x + dx, y + dy)) continue;
                    free[ground.place(x + dx, y + dy)] = 0;
                }
            }
        }
    }
    return free;
}

std::vector<Ground> groundsOf(const Arena& arena, const std::vector<double>& levels) {
    constexpr double Everything = std::numeric_limits<double>::infinity();
    std::vector<Ground> grounds;
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const double from = i == 0 ? -Everything : levels[i] - Sunk;
        const double to = i + 1 < levels.size() ? levels[i + 1] - Sunk : Everything;
        grounds.emplace_back(arena, ReachableFloor().cell, levels[i], from, to);
        if (i > 0) grounds[i].lookThrough(grounds[i - 1]);
    }
    return grounds;
}

/// Finds the squares that robots reach from their starts, over all storeys.
class Flood {
public:
    Flood(const std::vector<Ground>& grounds, double radius, double maxStep,
          std::vector<ReachableFloor>& floors)
        : m_grounds(grounds), m_maxStep(maxStep), m_floors(floors) {
        for (const Ground& ground : grounds)
            m_free.push_back(freeFor(ground, floors.front().cell, radius, maxStep));
    }

    void from(const std::map<std::string, Pose>& starts) {
        const ReachableFloor& first = m_floors.front();
        for (const auto& [name, start] : starts) {
            const Eigen::Vector2d square = (start.translation().head<2>() - first.from) / first.cell;
            for (std::size_t storey = 0; storey < m_grounds.size(); ++storey) {
                visit(storey, static_cast<int>(std::floor(square.x())),
                      static_cast<int>(std::floor(square.y())), start.translation().z());
            }
        }
        while (!m_waiting.empty()) {
            const Place place = m_waiting.back();
            m_waiting.pop_back();
            const Ground& ground = m_grounds[place.storey];
            const double height = ground.height[ground.place(place.x, place.y)];
            for (const auto& [dx, dy] : Neighbours) visit(place.storey, place.x + dx, place.y + dy, height);
            // An open square belongs to two storeys: the search goes on in the other one too.
            const std::size_t square = ground.place(place.x, place.y);
            if (ground.open[square] != 0) visit(place.storey - 1, place.x, place.y, height);
            if (place.storey + 1 < m_grounds.size() && m_grounds[place.storey + 1].open[square] != 0)
                visit(place.storey + 1, place.x, place.y, height);
        }
    }

private:
    struct Place {
        std::size_t storey;
        int x, y;
    };
    void visit(std::size_t storey, int x, int y, double height) {
        const Ground& ground = m_grounds[storey];
        if (x < 0 || y < 0 || x >= ground.columns || y >= ground.rows) return;
        const std::size_t square = ground.place(x, y);
        if (m_free[storey][square] == 0 || m_floors[storey].reached[square] != 0) return;
        if (std::abs(ground.height[square] - height) > m_maxStep) return;
        m_floors[storey].reached[square] = 1;
        m_waiting.push_back({storey, x, y});
    }

    const std::vector<Ground>& m_grounds;
    double m_maxStep;
    std::vector<ReachableFloor>& m_floors;
    std::vector<std::vector<char>> m_free;
    std::vector<Place> m_waiting;
};

}  // namespace

bool ReachableFloor::at(const Eigen::Vector2d& point) const {
    const Eigen::Vector2d square = (point - from) / cell;
    if (!(square.minCoeff() >= 0.0 && square.x() < columns && square.y() < rows)) return false;
    return reached[static_cast<std::size_t>(static_cast<int>(square.y()) * columns +
                                            static_cast<int>(square.x()))] != 0;
}

double ReachableFloor::area() const {
    return cell * cell * static_cast<double>(std::count(reached.begin(), reached.end(), 1));
}

double ReachableFloor::distanceTo(const Eigen::Vector2d& point) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
            if (reached[static_cast<std::size_t>(y * columns + x)] == 0) continue;
            nearest = std::min(nearest, (from + cell * Eigen::Vector2d(x + 0.5, y + 0.5) - point).norm());
        }
    }
    return nearest;
}

std::vector<ReachableFloor> reachableStoreys(const Arena& arena, double radius, double maxStep) {
    const std::vector<double> levels = levelsOf(arena);
    const std::vector<Ground> grounds = groundsOf(arena, levels);
    std::vector<ReachableFloor> floors(levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) {
        floors[i].level = levels[i];
        floors[i].from = arena.from;
        floors[i].columns = grounds[i].columns;
        floors[i].rows = grounds[i].rows;
        floors[i].reached.assign(grounds[i].height.size(), 0);
    }
    Flood(grounds, radius, maxStep, floors).from(arena.starts);
    return floors;
}

ReachableFloor reachableFloor(const Arena& arena, double radius, double maxStep) {
    return std::move(reachableStoreys(arena, radius, maxStep).front());
}

Eigen::Vector2d placeBefore(const Element& victim, double distance) {
    return (victim.pose * Eigen::Vector3d(0.2 * victim.size.x(), -victim.size.y() / 2 - distance, 0.0))
        .head<2>();
}

bool reaches(const ReachableFloor& floor, const Element& victim) {
    for (double distance = 0.3; distance <= VictimReach; distance += 0.05) {
        if (floor.at(placeBefore(victim, distance))) return true;
    }
    return false;
}

}  // namespace leitstand::simulation
