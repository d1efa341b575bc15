#include "core/mapping/sighting/seen_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/event/status_samples.h"
#include "core/mapping/sighting/floor_field.h"
#include "core/mapping/sighting/grouped.h"

namespace leitstand {
namespace {

constexpr double Cell = 0.05, FloorCell = 0.25;  ///< edges of grids [m]
constexpr double TallFrom = 0.12, TallTo = 0.8;  ///< over the body's height: of a wall, not of a ceiling [m]
constexpr double Linked = 0.10, LinkedOfRange = 0.03;  ///< points so near belong to one thing [m], [m / m]
constexpr double Known = 0.12;                         ///< points so near to the map are not new [m]
constexpr double SameThing = 0.2;                      ///< [m]

/// A point between floor and robot's height.
struct Low {
    Eigen::Vector2d place;  ///< [m]
    double ground, height;  ///< height of the floor in the map, of the point over it [m]
    bool fresh;
};

/// The smallest box around points, seen from above.
struct Box {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    double longer = 0.0, shorter = 0.0;
};

template <class Of>
Box boxOf(std::size_t count, Of of) {
    constexpr int Turns = 18;
    Box best;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < Turns; ++i) {
        const Eigen::Rotation2Dd turn(degrees(90.0 * i / Turns));
        Eigen::AlignedBox2d box;
        for (std::size_t k = 0; k < count; ++k) box.extend(turn * of(k));
        const Eigen::Vector2d size = box.sizes();
        if (count == 0 || size.sum() >= least) continue;
        least = size.sum();
        best = {turn.inverse() * box.center(), size.maxCoeff(), size.minCoeff()};
    }
    return best;
}

/// Returns groups of connected points, by their indices in @p points.
std::vector<std::vector<std::size_t>> things(const std::vector<Low>& points, const Eigen::Vector2d& scanner) {
    return grouped(points.size(), [&](std::size_t here, std::size_t other) {
        const double reach = Linked + LinkedOfRange * (points[here].place - scanner).norm();
        return (points[other].place - points[here].place).squaredNorm() > reach * reach;
    });
}

/// Finds bodies in one scan.
class BodySearch {
public:
    BodySearch(const Pose& scanInMap, const RobotBody& body, const SightingSettings& settings)
        : m_scanner(scanInMap.translation().head<2>()), m_body(body), m_settings(settings) {
        const Box box = boxOf(body.footprint.size(), [&](std::size_t i) { return body.footprint[i]; });
        m_longer = box.longer;
        m_shorter = box.shorter;
    }

    [[nodiscard]] std::vector<Low> low(const std::vector<Eigen::Vector3f>& points, const LocalMap& earlier,
                                       std::span<const Disc> others) const;
    /// Adds the bodies among @p points to @p found, unless they are there already.
    void find(const std::vector<Low>& points, std::vector<SeenBody>& found) const;

private:
    [[nodiscard]] bool fits(const Box& box, double top, std::size_t count) const {
        return count >= m_settings.leastPoints && box.longer <= m_longer + m_settings.larger &&
               box.shorter <= m_shorter + m_settings.larger &&
               box.longer >= m_settings.shortest * m_shorter && top >= m_settings.lowest * m_body.height;
    }

    Eigen::Vector2d m_scanner;
    const RobotBody& m_body;
    const SightingSettings& m_settings;
    double m_longer = 0.0, m_shorter = 0.0;  ///< of the footprint [m]
};

std::vector<Low> BodySearch::low(const std::vector<Eigen::Vector3f>& points, const LocalMap& earlier,
                                 std::span<const Disc> others) const {
    const double reach = m_settings.farthest;
    const FloorField floor(SquareGrid(m_scanner, reach, FloorCell), points);
    const SquareGrid grid(m_scanner, reach, Cell);
    std::vector<char> tall(grid.cells(), 0);  // around what is taller than the robot
    const auto standTall = [&](const Eigen::Vector3f& point) {
        const Eigen::Vector2d place = point.head<2>().cast<double>();
        const auto cell = grid.cellOf(place);
        const auto ground = cell ? floor.heightAt(place) : std::nullopt;
        if (!ground) return;
        const double above = double{point.z()} - *ground - m_body.height;
        if (above > TallFrom && above < TallTo) grid.about(*cell, [&](std::size_t one) { tall[one] = 1; });
    };
    for (const Eigen::Vector3f& point : points) standTall(point);
    for (const Eigen::Vector3f& point : earlier.cloud.points) standTall(point);
    std::vector<Low> found;
    for (const Eigen::Vector3f& point : points) {
        const Eigen::Vector2d place = point.head<2>().cast<double>();
        const auto cell = grid.cellOf(place);
        const auto ground = cell ? floor.heightAt(place) : std::nullopt;
        if (!ground || tall[*cell] != 0) continue;
        const double height = double{point.z()} - *ground;
        if (height < m_settings.floor || height > m_body.height + m_settings.higher) continue;
        const bool known = std::any_of(others.begin(), others.end(), [&](const Disc& disc) {
            return (place - disc.middle).norm() < disc.radius;
        });
        if (known) continue;
        const bool fresh =
            earlier.search != nullptr &&
            !earlier.search->nearest(point, Label::Unlabelled, static_cast<float>(Known * Known)).found();
        found.push_back({place, *ground, height, fresh});
    }
    return found;
}

void BodySearch::find(const std::vector<Low>& points, std::vector<SeenBody>& found) const {
    for (const std::vector<std::size_t>& thing : things(points, m_scanner)) {
        const Box box = boxOf(thing.size(), [&](std::size_t i) { return points[thing[i]].place; });
        SeenBody body;
        std::size_t fresh = 0;
        body.ground = std::numeric_limits<double>::infinity();
        for (const std::size_t i : thing) {
            const Low& point = points[i];
            body.points.push_back(point.place);
            body.ground = std::min(body.ground, point.ground);
            body.top = std::max(body.top, point.height);
            if (point.fresh) ++fresh;
        }
        if (!fits(box, body.top, thing.size())) continue;
        body.fresh = 2 * fresh > thing.size();
        // Only its near side is seen, so the middle is farther from the scanner.
        const Eigen::Vector2d away = (box.middle - m_scanner).normalized();
        double nearest = std::numeric_limits<double>::infinity(), farthest = -nearest;
        for (const Eigen::Vector2d& point : body.points) {
            nearest = std::min(nearest, point.dot(away));
            farthest = std::max(farthest, point.dot(away));
        }
        body.middle = box.middle + 0.5 * std::max(0.0, m_shorter - (farthest - nearest)) * away;
        const bool twice = std::any_of(found.begin(), found.end(), [&](const SeenBody& other) {
            return (other.middle - body.middle).norm() < SameThing;
        });
        if (!twice) found.push_back(std::move(body));
    }
}

}  // namespace

std::vector<SeenBody> seenBodies(const Scan& scan, const Pose& scanInMap, const RobotBody& body,
                                 const LocalMap& earlier, std::span<const Disc> others,
                                 const SightingSettings& settings) {
    std::vector<SeenBody> found;
    if (body.footprint.empty()) return found;
    const Eigen::Isometry3f motion = scanInMap.cast<float>();
    std::vector<Eigen::Vector3f> points;
    for (const Eigen::Vector3f& point : scan.points) {
        if (point.allFinite()) points.push_back(motion * point);
    }
    const BodySearch search(scanInMap, body, settings);
    std::vector<Low> low = search.low(points, earlier, others);
    search.find(low, found);
    // Beside something low, a body stands out by what is new to the map.
    std::erase_if(low, [](const Low& point) { return !point.fresh; });
    search.find(low, found);
    std::stable_sort(found.begin(), found.end(), [](const SeenBody& a, const SeenBody& b) {
        return a.fresh != b.fresh ? a.fresh : a.points.size() > b.points.size();
    });
    if (found.size() > settings.most) found.resize(settings.most);
    return found;
}

double shareWithin(const SeenBody& seen, const RobotBody& body, const Pose& baseInMap, double margin) {
    if (seen.points.empty()) return 0.0;
    const Pose mapInBase = baseInMap.inverse();
    const double ground = baseInMap.translation().z();
    const auto inside =
        std::count_if(seen.points.begin(), seen.points.end(), [&](const Eigen::Vector2d& point) {
            const Eigen::Vector3d there = mapInBase * Eigen::Vector3d(point.x(), point.y(), ground);
            return onFootprint(body, there.head<2>(), margin);
        });
    return static_cast<double>(inside) / static_cast<double>(seen.points.size());
}

}  // namespace leitstand
