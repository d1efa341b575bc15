#include "core/mapping/sighting/passing_bodies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "core/event/scan_bodies.h"
#include "core/mapping/live/map/local_map.h"
#include "core/mapping/live/scan_cleaning.h"
#include "core/mapping/sighting/floor_field.h"
#include "core/mapping/sighting/grouped.h"

namespace leitstand {
namespace {

constexpr double FloorCell = 0.25;                    ///< [m]
constexpr double Linked = 0.2, LinkedOfRange = 0.03;  ///< points so near belong to one thing [m], [m / m]
constexpr double About = 0.05;                        ///< margin around a thing [m]
constexpr std::size_t MostLooked = 400;               ///< scans that are kept in memory

/// Removes those of @p scans that were not used for longest, down to @p most.
template <class Scans>
void keepNewest(Scans& scans, std::size_t most) {
    while (scans.size() > most) {
        scans.erase(std::min_element(scans.begin(), scans.end(), [](const auto& a, const auto& b) {
            return a.second.used < b.second.used;
        }));
    }
}

/// Returns whether a person would see no difference.
bool alike(const std::vector<BodyInScan>& a, const std::vector<BodyInScan>& b) {
    constexpr double Noticed = 0.05;  // [m]
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](const BodyInScan& one, const BodyInScan& other) {
                          return distanceBetween(one.baseInScan, other.baseInScan) < Noticed &&
                                 (one.footprint.front() - other.footprint.front()).norm() < Noticed &&
                                 std::abs(one.height - other.height) < Noticed;
                      });
}

/// Returns groups of points that are connected, seen from above, by their indices in @p points.
std::vector<std::vector<std::size_t>> together(const std::vector<Eigen::Vector3f>& points) {
    return grouped(points.size(), [&](std::size_t here, std::size_t other) {
        const double reach = Linked + LinkedOfRange * static_cast<double>(points[here].norm());
        return static_cast<double>((points[other] - points[here]).head<2>().squaredNorm()) > reach * reach;
    });
}

}  // namespace

PassingBodies::Looked& PassingBodies::lookedAt(const LiveKeyScan& scan) {
    const auto [known, fresh] = m_looked.try_emplace(scan.id);
    Looked& looked = known->second;
    if (!fresh) return looked;
    const Eigen::Isometry3f inMap = scan.pose.scanInMap.cast<float>();
    std::vector<Eigen::Vector3f> points;
    points.reserve(scan.scan->points.size());
    for (const Eigen::Vector3f& point : scan.scan->points) {
        if (point.allFinite()) points.push_back(inMap * point);
    }
    const SquareGrid grid(scan.pose.scanInMap.translation().head<2>(), m_settings.reach, FloorCell);
    const FloorField floor(grid, points);
    std::set<std::tuple<int, int, int>> cells;
    const auto cell = [this](float coordinate) {
        return static_cast<int>(std::floor(static_cast<double>(coordinate) / m_settings.edge));
    };
    const Eigen::Isometry3f inScan = inMap.inverse();
    for (const Eigen::Vector3f& point : points) {
        const auto ground = floor.heightAt(point.head<2>().cast<double>());
        if (!ground) continue;
        const double height = static_cast<double>(point.z()) - *ground;
        if (height < m_settings.low || height > m_settings.high) continue;
        if (!cells.emplace(cell(point.x()), cell(point.y()), cell(point.z())).second) continue;
        looked.asked.push_back({inScan * point, static_cast<float>(height)});
    }
    looked.asked.shrink_to_fit();
    return looked;
}

void PassingBodies::vote(const LiveKeyScan& by, const LiveKeyScan& on) {
    Looked& asked = lookedAt(on);
    const FreeSpace& voter = m_voters.of(by.id, *by.scan);
    asked.used = ++m_votes;
    const Eigen::Isometry3f inVoter = (by.pose.scanInMap.inverse() * on.pose.scanInMap).cast<float>();
    constexpr std::uint8_t Most = std::numeric_limits<std::uint8_t>::max();
    for (Asked& one : asked.asked) {
        const SeenThere seen = voter.at(inVoter * one.place);
        std::uint8_t& votes = seen == SeenThere::LookedThrough ? one.through : one.seen;
        if (seen != SeenThere::Unknown && votes < Most) ++votes;
    }
}

std::vector<BodyInScan> PassingBodies::bodiesOf(const LiveKeyScan& scan, const Looked& looked) const {
    std::vector<const Asked*> passing;
    std::vector<Eigen::Vector3f> level;  // relative to the scanner, in the map's axes
    const Eigen::Matrix3f turned = scan.pose.scanInMap.linear().cast<float>();
    for (const Asked& one : looked.asked) {
        if (one.through <= one.seen) continue;
        passing.push_back(&one);
        level.push_back(turned * one.place);
    }
    std::vector<BodyInScan> bodies;
    for (const std::vector<std::size_t>& thing : together(level)) {
        const auto sure =
            std::count_if(thing.begin(), thing.end(), [&](std::size_t i) { return passed(*passing[i]); });
        if (sure < m_settings.leastPoints) continue;
        Eigen::AlignedBox2d box;
        double lowest = std::numeric_limits<double>::infinity(), highest = -lowest, ground = lowest;
        for (const std::size_t i : thing) {
            box.extend(level[i].head<2>().cast<double>());
            lowest = std::min(lowest, static_cast<double>(passing[i]->height));
            highest = std::max(highest, static_cast<double>(passing[i]->height));
            ground = std::min(ground, static_cast<double>(level[i].z() - passing[i]->height));
        }
        const double across = box.diagonal().norm();
        if (across < m_settings.narrowest || across > m_settings.largest ||
            highest - lowest < m_settings.tallest)
            continue;
        BodyInScan body;
        body.robot = Name;
        const Eigen::Vector2d half = 0.5 * box.sizes() + Eigen::Vector2d::Constant(About);
        body.footprint = {half, {-half.x(), half.y()}, -half, {half.x(), -half.y()}};
        body.height = std::max(0.0, highest + About - PlacedBody::Certain);
        body.baseInScan.linear() = scan.pose.scanInMap.linear().transpose();
        body.baseInScan.translation() =
            body.baseInScan.linear() * Eigen::Vector3d(box.center().x(), box.center().y(), ground);
        body.margin = About;
        bodies.push_back(std::move(body));
    }
    return bodies;
}

std::map<std::uint64_t, std::vector<BodyInScan>> PassingBodies::add(const LiveMap& map, std::uint64_t id,
                                                                    const std::set<std::uint64_t>& together) {
    std::map<std::uint64_t, std::vector<BodyInScan>> changed;
    const auto entered = std::find_if(map.scans.begin(), map.scans.end(),
                                      [id](const LiveKeyScan& one) { return one.id == id; });
    if (entered == map.scans.end() || !entered->counts() || entered->odometryFrame < 0) return changed;
    std::vector<std::pair<double, const LiveKeyScan*>> near;
    for (const LiveKeyScan& one : map.scans) {
        // Bodies that an earlier run left out of its scans are not looked for again.
        if (!one.counts() || one.id == id || one.odometryFrame < 0 || !together.contains(one.id)) continue;
        const double distance = mapDistance(one.pose.scanInMap, entered->pose.scanInMap);
        if (distance <= m_settings.reach) near.emplace_back(distance, &one);
    }
    std::sort(near.begin(), near.end(), [](const auto& a, const auto& b) {
        return std::pair(a.first, a.second->id) < std::pair(b.first, b.second->id);
    });
    near.resize(std::min(near.size(), m_settings.scans));
    for (const auto& [distance, one] : near) {
        vote(*entered, *one);
        vote(*one, *entered);
    }
    near.emplace_back(0.0, &*entered);
    for (const auto& [distance, one] : near) {
        Looked& looked = lookedAt(*one);
        std::vector<BodyInScan> bodies = bodiesOf(*one, looked);
        if (alike(bodies, looked.bodies)) continue;
        looked.bodies = bodies;
        changed.emplace(one->id, std::move(bodies));
    }
    keepNewest(m_looked, MostLooked);
    return changed;
}

}  // namespace leitstand
