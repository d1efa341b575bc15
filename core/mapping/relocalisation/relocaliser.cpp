#include "core/mapping/relocalisation/relocaliser.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/mapping/live/loops/places/free_space.h"
#include "core/mapping/live/map/local_map.h"

namespace leitstand {
namespace {

constexpr double StoreyWithin = 0.8;  ///< heights of scanners that see the same walls [m]
constexpr std::size_t FewestWalls = 40, WellWalled = 60;

/// Returns the best score of places around @p pose.
double besideOf(const WallRaster& walls, const std::vector<Eigen::Vector2f>& view, const FlatPose& pose) {
    constexpr double Beside = 0.6;  // [m]
    constexpr int Directions = 16;
    double best = 0.0;
    for (int i = 0; i < Directions; ++i) {
        const double direction = 2.0 * std::numbers::pi * i / Directions;
        FlatPose shifted = pose;
        shifted.place += Beside * Eigen::Vector2d(std::cos(direction), std::sin(direction));
        best = std::max(best, walls.scoreAt(view, shifted));
    }
    return best;
}

bool apart(const Pose& a, const Pose& b, const RasterSearch& search) {
    return distanceBetween(a, b) > 0.5 * search.apart || angleBetween(a, b) > 0.5 * search.turnedApart;
}

}  // namespace

RelocalisationSettings forLostRobots() {
    RelocalisationSettings settings;
    settings.alike = 0.88;
    settings.sureFilled = 0.05;
    settings.sureFit = 0.72;
    return settings;
}

Relocaliser::Relocaliser(LiveMapPtr map, LiveSettings settings, RelocalisationSettings how,
                         const Progress& progress)
    : m_map(std::move(map)), m_settings(std::move(settings)), m_how(std::move(how)) {
    std::vector<const LiveKeyScan*> scans;
    for (const LiveKeyScan& scan : m_map->scans) {
        if (scan.counts()) scans.push_back(&scan);
    }
    const auto heightOf = [](const LiveKeyScan& scan) { return scan.pose.scanInMap.translation().z(); };
    std::stable_sort(scans.begin(), scans.end(),
                     [&](const auto* a, const auto* b) { return heightOf(*a) < heightOf(*b); });
    std::vector<double> heights;
    for (const LiveKeyScan* scan : scans) {
        if (heights.empty() || heightOf(*scan) > heights.back() + StoreyWithin)
            heights.push_back(heightOf(*scan));
    }
    WallBand all = m_how.walls;
    all.reach = std::numeric_limits<double>::infinity();
    for (const double lowest : heights) {
        const double height = lowest + 0.5 * StoreyWithin;
        std::vector<Eigen::Vector2f> walls;
        for (const LiveKeyScan* scan : scans) {
            if (progress.cancelled()) return;
            if (std::abs(heightOf(*scan) - height) > StoreyWithin) continue;
            const Eigen::Isometry3f there = scan->pose.scanInMap.cast<float>();
            const PointCloud cloud = scan->reduced->unpacked();
            for (const Eigen::Vector2f& wall : wallsFromAbove(cloud, there.linear(), all))
                walls.push_back(wall + there.translation().head<2>());
        }
        m_storeys.push_back({height, WallRaster(walls)});
    }
}

std::optional<double> Relocaliser::filledAt(const Scan& scan, const Pose& scanInMap) const {
    constexpr std::size_t Nearest = 3;  // one may stand behind a wall
    std::vector<std::pair<double, const LiveKeyScan*>> about;
    for (const LiveKeyScan& one : m_map->scans) {
        if (one.counts()) about.emplace_back(mapDistance(one.pose.scanInMap, scanInMap), &one);
    }
    const std::size_t count = std::min(Nearest, about.size());
    std::partial_sort(about.begin(), about.begin() + static_cast<std::ptrdiff_t>(count), about.end(),
                      [](const auto& a, const auto& b) { return a.first < b.first; });
    std::optional<double> most;
    for (std::size_t i = 0; i < count; ++i) {
        const LiveKeyScan& key = *about[i].second;
        const Pose inKey = key.pose.scanInMap.inverse() * scanInMap;
        const FreeSpaceFit fit = FreeSpace(key.scan->points).fit(scan.points, inKey);
        const auto judged = static_cast<double>(fit.agreed + fit.filled);
        if (judged < m_how.leastJudged * static_cast<double>(scan.points.size())) continue;
        most = std::max(most.value_or(0.0), filledShare(*key.scan, scan, inKey));
    }
    return most;
}

std::optional<AlikePlace> Relocaliser::verified(const Sought& sought, const RasterPlace& place,
                                                const Storey& storey) const {
    Pose guess = place.pose.standing(storey.height) * sought.level;
    double least = std::numeric_limits<double>::infinity(), height = storey.height;
    for (const LiveKeyScan& one : m_map->scans) {
        const double distance = mapDistance(one.pose.scanInMap, guess);
        if (!one.counts() || distance >= least) continue;
        least = distance;
        height = one.pose.scanInMap.translation().z();
    }
    guess.translation().z() = height;
    const LocalMap local = localMap(m_map->scans, guess, m_settings.local);
    const Match found =
        match(sought.reduced, local, guess, {}, sought.up, m_settings.match, m_settings.fit, m_how.schedule);
    if (found.doubts != 0 || found.icp.overlap < m_how.leastOverlap || found.icp.rms > m_how.mostResidual)
        return std::nullopt;
    const auto filled = filledAt(sought.scan, found.scanInMap);
    if (!filled || *filled > m_how.mostFilled) return std::nullopt;
    const FlatPose flat = FlatPose::of(found.scanInMap * sought.level.inverse());
    return AlikePlace{found.scanInMap,
                      storey.walls.scoreAt(sought.view, flat),
                      besideOf(storey.walls, sought.view, flat),
                      found.icp.overlap,
                      found.icp.rms,
                      *filled};
}

Relocalisation Relocaliser::find(const Scan& scan, const PointCloud& reduced, const Eigen::Vector3d& up,
                                 const Progress& progress) const {
    Relocalisation result;
    const Pose level = levelled(Pose::Identity(), up, 1.0);
    const auto wallsWithin = [&](double reach) {
        const WallBand band{m_how.walls.low, m_how.walls.high, reach};
        return thinnedWalls(wallsFromAbove(reduced, level.linear().cast<float>(), band));
    };
    Sought sought{scan, reduced, up, level, wallsWithin(m_how.walls.reach)};
    // In a hall walls are far, and few.
    if (sought.view.size() < WellWalled) sought.view = wallsWithin(m_how.farReach);
    if (sought.view.size() < FewestWalls) return result;
    struct Candidate {
        RasterPlace place;
        const Storey* storey;
    };
    std::vector<Candidate> candidates;
    double others = 0.0;  // the best score of places that are not tried
    for (const Storey& storey : m_storeys) {
        const RasterPlaces found = storey.walls.find(sought.view, m_how.search, progress);
        if (progress.cancelled()) return {};
        for (const RasterPlace& place : found.places) candidates.push_back({place, &storey});
        others = std::max(others, found.others);
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.place.score > b.place.score; });
    const auto most = static_cast<std::size_t>(m_how.search.most);
    if (candidates.size() > most) {
        others = std::max(others, candidates[most].place.score);
        candidates.resize(most);
    }
    result.tried = candidates.size();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        if (progress.cancelled()) return {};
        const auto place = verified(sought, candidates[i].place, *candidates[i].storey);
        progress.done(double(i + 1) / double(candidates.size()));
        if (!place) continue;
        // Two places that look different from above may lead to the same pose.
        const bool known = std::any_of(
            result.places.begin(), result.places.end(),
            [&](const AlikePlace& one) { return !apart(one.scanInMap, place->scanInMap, m_how.search); });
        if (!known) result.places.push_back(*place);
    }
    std::stable_sort(result.places.begin(), result.places.end(),
                     [](const AlikePlace& a, const AlikePlace& b) { return a.fit() > b.fit(); });
    if (result.places.empty()) return result;
    const AlikePlace& best = result.places.front();
    const double alike = m_how.alike - m_how.alikeFilled * best.filled;
    const bool alone = result.places.size() == 1 || result.places[1].fit() < alike * best.fit();
    const bool agreed = std::all_of(result.places.begin(), result.places.end(), [&](const AlikePlace& one) {
        return one.score <= best.score + m_how.betterFromAbove;
    });
    result.sure = alone && agreed && best.fit() >= m_how.sureFit && best.filled <= m_how.sureFilled &&
                  std::max(others, best.beside) < m_how.alikeFromAbove * best.score;
    return result;
}

}  // namespace leitstand
