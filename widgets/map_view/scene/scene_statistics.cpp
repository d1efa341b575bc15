#include "widgets/map_view/scene/scene_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace leitstand {
namespace {

constexpr std::size_t SampleSize = 30'000;
constexpr double LeastAgeStep = 0.1;   ///< step to which the end of a ramp of ages is rounded [min]
constexpr double MostAgeSteps = 16.0;  ///< most steps in a ramp of ages

/// Returns the value below which a share of @p values lies; reorders them.
double quantile(std::vector<double>& values, double share) {
    const auto index = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + index, values.end());
    return values[static_cast<std::size_t>(index)];
}

/// A cube of space, how many points are in it, and one of them.
struct Place {
    std::array<double, 3> cell;
    std::size_t points = 0;
    Eigen::Vector3d example;
};

std::vector<Place> occupiedPlaces(const std::vector<Eigen::Vector3d>& points) {
    constexpr double CellsPerMetre = 2.0;
    std::vector<Place> places;
    places.reserve(points.size());
    for (const Eigen::Vector3d& point : points) {
        const Eigen::Array3d cell = (CellsPerMetre * point.array()).floor();
        places.push_back({{cell.x(), cell.y(), cell.z()}, 1, point});
    }
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.cell < b.cell; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < places.size(); ++i) {
        if (places[i].cell == places[last].cell) {
            ++places[last].points;
        } else {
            places[++last] = places[i];
        }
    }
    if (!places.empty()) places.resize(last + 1);
    return places;
}

ColourRamp rounded(double low, double high, double step) {
    const double first = std::floor(low / step) * step;
    return {first, std::max(std::ceil(high / step) * step, first + step)};
}

}  // namespace

bool isShown(double height, Label label, const MapViewSettings& settings) {
    if (settings.minHeight && height < *settings.minHeight) return false;
    if (settings.maxHeight && height > *settings.maxHeight) return false;
    return settings.withCeiling() || label != Label::Ceiling;
}

SceneStatistics statisticsOf(const SceneContent& content) {
    std::size_t total = 0;
    for (const SceneScan& scan : content.scans) {
        if (scan.visible && scan.points) total += scan.points->points.size();
    }
    SceneStatistics sample;
    const double share = std::min(1.0, static_cast<double>(SampleSize) / static_cast<double>(total + 1));
    for (const SceneScan& scan : content.scans) {
        if (!scan.visible || !scan.points) continue;
        const auto count =
            static_cast<std::size_t>(std::ceil(share * static_cast<double>(scan.points->points.size())));
        for (std::size_t i = 0; i < std::min(count, scan.points->points.size()); ++i) {
            const Eigen::Vector3d inScan = scan.points->sample(i).cast<double>();
            const Eigen::Vector3d inMap = scan.poseInMap * inScan;
            if (!isShown(inMap.z(), scan.points->labelOfSample(i), content.settings)) continue;
            sample.points.push_back(inMap);
            sample.ranges.push_back(inScan.norm());
            if (scan.points->shades) sample.shades.push_back(scan.points->shadeOfSample(i));
        }
    }
    return sample;
}

std::vector<Eigen::Vector3d> filledPlaces(const SceneStatistics& sample) {
    constexpr double Stray = 0.01;  ///< share of the points left out: those in the emptiest places
    std::vector<Place> places = occupiedPlaces(sample.points);
    std::stable_sort(places.begin(), places.end(),
                     [](const Place& a, const Place& b) { return a.points < b.points; });
    auto mayGo = static_cast<std::size_t>(Stray * static_cast<double>(sample.points.size()));
    std::vector<Eigen::Vector3d> filled;
    for (const Place& place : places) {
        if (filled.empty() && place.points <= mayGo) {
            mayGo -= place.points;
        } else {
            filled.push_back(place.example);
        }
    }
    return filled;
}

std::optional<ColourRamp> rampOf(const SceneStatistics& sample, MapColouring colouring) {
    if (sample.points.empty()) return std::nullopt;
    if (colouring == MapColouring::Height) {
        std::vector<double> heights;
        heights.reserve(sample.points.size());
        for (const Eigen::Vector3d& point : sample.points) heights.push_back(point.z());
        return rounded(quantile(heights, 0.01), quantile(heights, 0.99), 0.1);
    }
    if (colouring == MapColouring::Range) {
        std::vector<double> ranges = sample.ranges;
        return rounded(0.0, quantile(ranges, 0.98), 1.0);
    }
    if (colouring == MapColouring::Intensity && !sample.shades.empty()) {
        std::vector<double> shades = sample.shades;
        return rounded(quantile(shades, 0.02), quantile(shades, 0.98), 8.0);
    }
    return std::nullopt;
}

std::optional<ColourRamp> rampOfAges(const SceneContent& content) {
    if (content.scans.empty()) return std::nullopt;
    double newest = 0.0;
    for (const SceneScan& scan : content.scans) newest = std::max(newest, scan.age);
    double step = content.ages == SceneAges::Minutes ? LeastAgeStep : 1.0;
    while (MostAgeSteps * step < newest) step *= 2.0;
    return rounded(0.0, newest, step);
}

}  // namespace leitstand
