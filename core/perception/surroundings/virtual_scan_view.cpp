#include "core/perception/surroundings/virtual_scan_view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "core/event/all_samples.h"

namespace leitstand {
namespace {

constexpr double Pi = std::numbers::pi;
constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Calls @p visit for the sectors from @p from counter-clockwise to @p to.
template <class Visit>
void eachSector(const VirtualScanView& view, double from, double to, const Visit& visit) {
    const int count = static_cast<int>(view.sectors.size());
    if (count == 0) return;
    const int first = view.sectorOf(from);
    const bool all = to - from >= 2.0 * Pi;
    const int last = all ? (first + count - 1) % count : view.sectorOf(to);
    for (int i = first;; i = (i + 1) % count) {
        visit(view.sectors[static_cast<std::size_t>(i)]);
        if (i == last) return;
    }
}

/// Whether @p direction lies from @p from counter-clockwise to @p to.
bool isWithin(double direction, double from, double to) {
    if (to - from >= 2.0 * Pi) return true;
    const auto turned = [from](double angle) {
        const double turn = std::fmod(angle - from, 2.0 * Pi);
        return turn < 0.0 ? turn + 2.0 * Pi : turn;
    };
    return turned(direction) <= turned(to);
}

}  // namespace

double BodyBox::reach() const {
    return std::hypot(std::max(front, back), std::max(left, right));
}

BodyBox BodyBox::grown(double margin) const {
    return {front + margin, back + margin, left + margin, right + margin};
}

double BodyBox::depth(const Eigen::Vector2d& point) const {
    return std::min({front - point.x(), point.x() + back, left - point.y(), point.y() + right});
}

BodyBox boxAround(const std::vector<Eigen::Vector2d>& footprint) {
    BodyBox box;
    for (const Eigen::Vector2d& corner : footprint) {
        box.front = std::max(box.front, corner.x());
        box.back = std::max(box.back, -corner.x());
        box.left = std::max(box.left, corner.y());
        box.right = std::max(box.right, -corner.y());
    }
    return box;
}

int VirtualScanView::sectorOf(double direction) const {
    const int count = static_cast<int>(sectors.size());
    const double turned = (std::remainder(direction, 2.0 * Pi) + Pi) / (2.0 * Pi);
    return std::clamp(static_cast<int>(std::floor(turned * count)), 0, std::max(0, count - 1));
}

double VirtualScanView::directionOf(int sector) const {
    return (sector + 0.5) * 2.0 * Pi / static_cast<double>(sectors.size()) - Pi;
}

void VirtualScanView::closeGaps(int widest) {
    const int count = static_cast<int>(sectors.size());
    const auto at = [this, count](int i) -> const VirtualSector& {
        return sectors[static_cast<std::size_t>((i % count + count) % count)];
    };
    std::vector<VirtualSector> closed = sectors;
    /// Fills what sector i lacks from the next ones on both sides that have it, if they are close enough.
    const auto close = [&](int i, int most, const auto& has, const auto& join) {
        int before = 1, after = 1;
        while (before <= most && !has(at(i - before))) ++before;
        while (after <= most && !has(at(i + after))) ++after;
        if (before + after <= most + 1)
            join(closed[static_cast<std::size_t>(i)], at(i - before), at(i + after));
    };
    /// Middle of two points of one surface; empty when they are too far apart for that.
    const auto middle = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        const double apart = (a - b).norm();
        return apart < 0.15 + 0.1 * a.norm() ? std::optional<Eigen::Vector2d>(0.5 * (a + b)) : std::nullopt;
    };
    for (int i = 0; i < count; ++i) {
        if (!std::isfinite(at(i).age)) {
            close(
                i, widest, [](const VirtualSector& one) { return std::isfinite(one.age); },
                [](VirtualSector& gap, const VirtualSector& a, const VirtualSector& b) {
                    gap.age = std::max(a.age, b.age);
                });
        }
        if (!at(i).outer) {
            close(
                i, widest, [](const VirtualSector& one) { return one.outer.has_value(); },
                [&](VirtualSector& gap, const VirtualSector& a, const VirtualSector& b) {
                    gap.outer = middle(*a.outer, *b.outer);
                });
        }
        if (!at(i).inner) {
            close(
                i, std::min(widest, 2), [](const VirtualSector& one) { return one.inner.has_value(); },
                [&](VirtualSector& gap, const VirtualSector& a, const VirtualSector& b) {
                    gap.inner = middle(*a.inner, *b.inner);
                });
        }
    }
    sectors = std::move(closed);
}

void VirtualScanView::bridgeEdges(int widest) {
    const int count = static_cast<int>(sectors.size());
    const std::vector<VirtualSector> seen = sectors;
    const auto at = [&](int i) -> const VirtualSector& {
        return seen[static_cast<std::size_t>((i % count + count) % count)];
    };
    const auto lengthOf = [](const VirtualSector& sector) {
        const double outer = sector.outer ? sector.outer->norm() : Infinity;
        return sector.inner ? std::min(outer, sector.inner->norm()) : outer;
    };
    for (int i = 0; i < count; ++i) {
        if (std::isfinite(at(i).age)) continue;
        int before = 1, after = 1;
        while (before <= widest && !std::isfinite(at(i - before).age)) ++before;
        while (after <= widest && !std::isfinite(at(i + after).age)) ++after;
        if (before + after > widest + 1) continue;
        const VirtualSector &right = at(i - before), &left = at(i + after);
        VirtualSector& sector = sectors[static_cast<std::size_t>(i)];
        sector.age = std::max(right.age, left.age);
        const double length = std::min(lengthOf(right), lengthOf(left));
        const double direction = directionOf(i);
        if (std::isfinite(length))
            sector.outer = length * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    }
}

double VirtualScanView::nearest(double from, double to, double maxAge) const {
    double best = Infinity;
    for (const VirtualObstacle& one : obstacles) {
        if (one.age <= maxAge && isWithin(std::atan2(one.where.y(), one.where.x()), from, to))
            best = std::min(best, one.where.norm());
    }
    return best;
}

double VirtualScanView::oldest(double from, double to) const {
    double age = sectors.empty() ? Infinity : 0.0;
    eachSector(*this, from, to, [&age](const VirtualSector& sector) { age = std::max(age, sector.age); });
    return age;
}

double VirtualScanView::youngest() const {
    double age = std::numeric_limits<double>::infinity();
    for (const VirtualSector& sector : sectors) age = std::min(age, sector.age);
    return age;
}

double VirtualScanView::freeLength(double direction, double width, double limit) const {
    const Eigen::Vector2d along(std::cos(direction), std::sin(direction));
    double length = limit;
    for (const VirtualObstacle& one : obstacles) {
        const double ahead = along.dot(one.where);
        const double aside = along.x() * one.where.y() - along.y() * one.where.x();
        if (ahead > 0.0 && std::abs(aside) < 0.5 * width) length = std::min(length, ahead);
    }
    return length;
}

double VirtualScanView::freeTravel(double forward, double turn, const BodyBox& body, double limit) const {
    constexpr double Step = 0.03;       // [m]
    constexpr double Worsened = 0.004;  // deeper within the body than before [m]
    const double speed = std::abs(forward) + std::abs(turn) * body.reach();
    if (!(speed > 1e-6) || !std::isfinite(speed)) return limit;
    std::vector<Eigen::Vector2d> near;
    for (const VirtualObstacle& one : obstacles) {
        if (one.where.norm() < body.reach() + limit) near.push_back(one.where);
    }
    for (double travel = Step; travel < limit + Step; travel += Step) {
        const double seconds = std::min(travel, limit) / speed;
        const double yaw = turn * seconds;
        const Eigen::Vector2d moved =
            std::abs(turn) < 1e-6 ? Eigen::Vector2d(forward * seconds, 0.0)
                                  : Eigen::Vector2d(std::sin(yaw), 1.0 - std::cos(yaw)) * (forward / turn);
        const Eigen::Rotation2Dd back(-yaw);
        for (const Eigen::Vector2d& one : near) {
            const double depth = body.depth(back * (one - moved));
            if (depth > 0.0 && depth > std::max(0.0, body.depth(one)) + Worsened)
                return std::max(0.0, travel - Step);
        }
    }
    return limit;
}

}  // namespace leitstand
