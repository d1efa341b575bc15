#include "core/mapping/storeys.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

namespace leitstand {
namespace {

constexpr double Apart = 1.8;  ///< of storeys, at least [m]
constexpr double About = 0.6;  ///< scanners of one storey are so near its height, since robots differ [m]
constexpr double Beside = 2.0 * About;  ///< there a storey has few scans, which lead to the next one [m]
constexpr double Fewer = 0.5;           ///< share of its own scans, at most
constexpr std::size_t Least = 4, Enough = 12;  ///< scans of a storey: at least, and enough in any map
constexpr double LeastShare = 0.04;            ///< between these, of all scans
constexpr double Near = 3.0;          ///< within this level distance of a scanner, floor bears its robot [m]
constexpr double ScannerAbove = 0.5;  ///< over the floor, where none was seen [m]
constexpr std::size_t Looked = 40;    ///< scans whose floor is measured ...
constexpr std::size_t PointsOfEach = 500;  ///< ... by so many points each
constexpr double BelowFloor = 0.6;         ///< heights from so far below a floor on belong to its storey [m]

/// Returns how many of @p heights, which are sorted, are near @p height.
std::size_t countAbout(const std::vector<double>& heights, double height) {
    return static_cast<std::size_t>(std::upper_bound(heights.begin(), heights.end(), height + About) -
                                    std::lower_bound(heights.begin(), heights.end(), height - About));
}

/// Returns the heights of scanners at which storeys are, the fullest first.
std::vector<double> levelsOf(const std::vector<double>& heights) {
    struct Level {
        double height;
        std::size_t scans;
    };
    std::vector<Level> levels;
    levels.reserve(heights.size());
    for (const double height : heights) levels.push_back({height, countAbout(heights, height)});
    std::stable_sort(levels.begin(), levels.end(),
                     [](const Level& a, const Level& b) { return a.scans > b.scans; });
    const auto least =
        std::clamp(static_cast<std::size_t>(LeastShare * static_cast<double>(heights.size())), Least, Enough);
    std::vector<double> found;
    for (const Level& level : levels) {
        if (level.scans < least && !found.empty()) break;
        const bool near = std::any_of(found.begin(), found.end(),
                                      [&](double other) { return std::abs(other - level.height) < Apart; });
        const auto beside = static_cast<double>(
            std::max(countAbout(heights, level.height - Beside), countAbout(heights, level.height + Beside)));
        if (found.empty() || (!near && beside <= Fewer * static_cast<double>(level.scans)))
            found.push_back(level.height);
    }
    return found;
}

/// Returns the height of the floor around the scanners at @p level [m].
double floorAt(std::span<const ReportScan> all, double level) {
    std::vector<const ReportScan*> scans;
    for (const ReportScan& scan : all) {
        if (std::abs(scan.scanInMap.translation().z() - level) <= About) scans.push_back(&scan);
    }
    std::vector<double> heights;
    const std::size_t every = std::max<std::size_t>(1, scans.size() / Looked);
    for (std::size_t i = 0; i < scans.size(); i += every) {
        const Scan& scan = *scans[i]->scan;
        const Pose& pose = scans[i]->scanInMap;
        const std::size_t step = std::max<std::size_t>(1, scan.points.size() / PointsOfEach);
        for (std::size_t point = 0; point < std::min(scan.points.size(), scan.labels.size()); point += step) {
            if (scan.labels[point] != Label::Floor || !scan.points[point].allFinite()) continue;
            const Eigen::Vector3d inMap = pose * scan.points[point].cast<double>();
            if ((inMap - pose.translation()).head<2>().norm() <= Near) heights.push_back(inMap.z());
        }
    }
    if (heights.empty()) return level - ScannerAbove;
    const auto middle = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2);
    std::nth_element(heights.begin(), middle, heights.end());
    return *middle;
}

}  // namespace

std::vector<Storey> storeysOf(const Map& map) {
    std::vector<ReportScan> scans;
    for (const MapScan& scan : map.scans) {
        if (!scan.uncertain) scans.push_back({.scan = scan.scan, .scanInMap = scan.poseInMap});
    }
    return storeysOf(scans);
}

std::vector<Storey> storeysOf(std::span<const ReportScan> scans) {
    std::vector<double> heights;
    for (const ReportScan& scan : scans) {
        if (const double height = scan.scanInMap.translation().z(); std::isfinite(height))
            heights.push_back(height);
    }
    if (heights.empty()) return {};
    const double first = heights.front();
    std::sort(heights.begin(), heights.end());
    std::vector<double> levels = levelsOf(heights);
    std::sort(levels.begin(), levels.end());
    const auto begins = std::min_element(levels.begin(), levels.end(), [first](double a, double b) {
        return std::abs(a - first) < std::abs(b - first);
    });
    std::vector<Storey> storeys;
    for (auto level = levels.begin(); level != levels.end(); ++level)
        storeys.push_back({static_cast<int>(level - begins), floorAt(scans, *level)});
    return storeys;
}

std::string storeyName(int number) {
    if (number == 0) return "0";
    return (number > 0 ? "+" : "\u2212") + std::to_string(std::abs(number));
}

StoreyHeights heightsOf(const std::vector<Storey>& storeys, std::size_t index) {
    StoreyHeights heights{storeys.at(index).floor - BelowFloor, std::nullopt};
    if (index + 1 < storeys.size()) heights.to = storeys[index + 1].floor - BelowFloor;
    return heights;
}

std::vector<StoreyShare> sharesOf(const std::vector<Storey>& storeys) {
    if (storeys.empty()) return {StoreyShare{}};
    std::vector<StoreyShare> shares;
    for (std::size_t i = 0; i < storeys.size(); ++i)
        shares.push_back({storeys[i].number, heightsOf(storeys, i)});
    shares.front().heights.from = StoreyHeights{}.from;
    return shares;
}

std::size_t shareAt(std::span<const StoreyShare> shares, double z) {
    for (std::size_t i = shares.size(); i > 1; --i) {
        if (z >= shares[i - 1].heights.from) return i - 1;
    }
    return 0;
}

}  // namespace leitstand
