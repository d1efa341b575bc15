#include "widgets/map_view/scene/scene_assembler.h"

#include <algorithm>
#include <chrono>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "widgets/map_view/scene/scene_statistics.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds PartInterval(150);

/// Amber in the points of a scan that does not fit, and in those of the one that stands out.
constexpr double UncertainTint = 0.7, HighlightTint = 0.9;
/// One of so many points of an uncertain scan is drawn: what is behind shines through.
constexpr std::size_t UncertainOneOf = 3;

std::shared_ptr<const PointOrder> shownPoints(const ScanPoints& points, bool withCeiling, bool thinned) {
    const std::size_t ceiling = points.labelCounts[static_cast<std::size_t>(Label::Ceiling)];
    if (!thinned && (withCeiling || ceiling == 0)) return points.order;
    std::vector<std::uint32_t> shown;
    const std::size_t count = points.points.size() / (thinned ? UncertainOneOf : 1);
    shown.reserve(thinned ? count : count - ceiling);
    for (std::size_t i = 0; i < count; ++i) {
        if (withCeiling || points.labelOfSample(i) != Label::Ceiling) {
            shown.push_back(static_cast<std::uint32_t>((*points.order)[i]));
        }
    }
    return std::make_shared<const PointOrder>(shown);
}

Rgba onRamp(double value, const ColourRamp& ramp) {
    return viridis((value - ramp.low) / (ramp.high - ramp.low));
}

/// Of all points of @p scan, the @p index -th of @p content, where the scan decides their colour.
Rgba colourOf(const SceneScan& scan, std::size_t index, const SceneContent& content) {
    switch (content.settings.colouring) {
        case MapColouring::Robot:
            return robotColour(content.robots[scan.robotAt].place, content.settings.theme);
        case MapColouring::Age:
            return onRamp(scan.age, content.ramp.value_or(ColourRamp{}));
        case MapColouring::Scan:
            return scanColour(index);
        default:
            return {};
    }
}

std::vector<Rgba> coloursOf(const ScanPoints& points, const MapViewSettings& settings, const Pose& poseInMap,
                            const ColourRamp& ramp, Rgba one) {
    const Eigen::RowVector3d heightAxis = poseInMap.linear().row(2);
    const double heightOffset = poseInMap.translation().z();
    const bool top = settings.look == MapLook::Top;
    const Rgba ground = mapColours(settings.theme).ground;
    std::vector<Rgba> colours(points.points.size());
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const Eigen::Vector3f& point = points.points[i];
        if (top && points.labels[i] == Label::Floor) {
            colours[i] = ground;
            continue;
        }
        switch (settings.colouring) {
            case MapColouring::Label:
                colours[i] = labelColour(points.labels[i]);
                break;
            case MapColouring::Scan:
            case MapColouring::Robot:
            case MapColouring::Age:
                colours[i] = one;
                break;
            case MapColouring::Height:
                colours[i] = onRamp(heightAxis.dot(point.cast<double>()) + heightOffset, ramp);
                break;
            case MapColouring::Range:
                colours[i] = onRamp(point.norm(), ramp);
                break;
            case MapColouring::Intensity:
                colours[i] =
                    points.shades ? onRamp((*points.shades)[i], ramp) : labelColour(Label::Unlabelled);
                break;
        }
    }
    return colours;
}

/// When @p scan came in: by the station's clock, else by its robot's; epoch: nobody knows.
Time timeOf(const MapScan& scan) {
    return scan.entered != Time{} ? scan.entered : scan.scan->end;
}

void addAges(const Map& map, SceneContent& content) {
    if (map.scans.empty()) return;
    Time first = timeOf(map.scans.front());
    bool timed = true;
    for (const MapScan& scan : map.scans) {
        timed = timed && timeOf(scan) != Time{};
        first = std::min(first, timeOf(scan));
    }
    content.ages = timed ? SceneAges::Minutes : SceneAges::Scans;
    for (std::size_t i = 0; i < map.scans.size(); ++i) {
        const std::chrono::duration<double, std::ratio<60>> minutes = timeOf(map.scans[i]) - first;
        content.scans[i].age = timed ? minutes.count() : static_cast<double>(i);
    }
}

/// Where @p robot is in @p robots; added where it is not.
std::size_t placeOf(const std::string& robot, std::vector<SceneRobot>& robots) {
    const auto known =
        std::find_if(robots.begin(), robots.end(), [&](const SceneRobot& one) { return one.name == robot; });
    const auto at = static_cast<std::size_t>(known - robots.begin());
    if (known == robots.end()) robots.push_back({robot, robot, -1});
    return at;
}

SceneContent outline(const SceneOrder& order) {
    SceneContent content;
    content.order = order.number;
    content.settings = order.settings;
    content.robots = order.robots;
    if (!order.map) return content;
    for (std::size_t i = 0; i < order.map->scans.size(); ++i) {
        const MapScan& scan = order.map->scans[i];
        SceneScan shown;
        shown.name = scan.scan->name;
        shown.robot = scan.scan->robot;
        shown.robotAt = placeOf(shown.robot, content.robots);
        shown.id = scan.id;
        shown.uncertain = scan.uncertain;
        shown.poseInMap = order.settings.poses == MapPoses::Guess ? scan.guessInMap : scan.poseInMap;
        shown.visible = i >= order.scanIsVisible.size() || order.scanIsVisible[i];
        content.scans.push_back(std::move(shown));
    }
    addAges(*order.map, content);
    return content;
}

}  // namespace

SceneContentPtr SceneAssembler::assemble(const SceneOrder& order, const std::function<bool()>& interrupted,
                                         const std::function<void(SceneContentPtr)>& onPart) {
    using Clock = std::chrono::steady_clock;
    SceneContent content = outline(order);
    forgetAllBut(order.map ? *order.map : Map{});
    const auto finish = [&](std::size_t count) {
        const SceneSample sample = sampleOf(content);
        content.places = filledPlaces(sample);
        for (const SceneScan& scan : content.scans) {
            if (scan.visible && scan.points) content.places.emplace_back(scan.poseInMap.translation());
        }
        content.ramp = order.settings.colouring == MapColouring::Age
                           ? rampOfAges(content)
                           : rampOf(sample, order.settings.colouring);
        for (std::size_t i = 0; i < count && order.settings.look != MapLook::Voxels; ++i) {
            addLook(content.scans[i], readyFor(order.map->scans[i].scan, order.settings), i, content,
                    order.highlighted);
        }
    };
    Clock::time_point lastPart = Clock::now();
    for (std::size_t i = 0; i < content.scans.size(); ++i) {
        if (interrupted()) return nullptr;
        content.scans[i].points = readyFor(order.map->scans[i].scan, order.settings).points;
        if (i + 1 == content.scans.size() || Clock::now() - lastPart < PartInterval) continue;
        finish(i + 1);
        content.complete = false;
        onPart(std::make_shared<const SceneContent>(content));
        content.complete = true;
        lastPart = Clock::now();
    }
    finish(content.scans.size());
    if (order.settings.look == MapLook::Voxels && !addVoxels(content, interrupted)) return nullptr;
    return std::make_shared<const SceneContent>(std::move(content));
}

void SceneAssembler::forgetAllBut(const Map& map) {
    std::unordered_set<const Scan*> kept;
    for (const MapScan& scan : map.scans) kept.insert(scan.scan.get());
    std::erase_if(m_ready, [&kept](const auto& ready) { return !kept.contains(ready.first); });
}

SceneAssembler::Ready& SceneAssembler::readyFor(const ScanPtr& scan, const MapViewSettings& settings) {
    Ready& ready = m_ready[scan.get()];
    if (!ready.points || ready.minRange != settings.minRange || ready.maxRange != settings.maxRange) {
        ready = Ready();
        ready.scan = scan;
        ready.minRange = settings.minRange;
        ready.maxRange = settings.maxRange;
        ready.points =
            std::make_shared<const ScanPoints>(drawablePoints(scan, settings.minRange, settings.maxRange));
    }
    return ready;
}

void SceneAssembler::addLook(SceneScan& scan, Ready& ready, std::size_t index, const SceneContent& content,
                             std::uint64_t highlighted) {
    const MapViewSettings& settings = content.settings;
    const bool withCeiling = settings.withCeiling();
    const bool standsOut = scan.id != 0 && scan.id == highlighted;
    const bool thinned = scan.uncertain && !standsOut;
    if (!ready.shown || ready.withCeiling != withCeiling || ready.thinned != thinned) {
        ready.withCeiling = withCeiling;
        ready.thinned = thinned;
        ready.shown = shownPoints(*ready.points, withCeiling, thinned);
    }
    const double tint = !scan.uncertain ? 0.0 : standsOut ? HighlightTint : UncertainTint;
    const ColourRamp ramp = content.ramp.value_or(ColourRamp{});
    const Rgba one = colourOf(scan, index, content);
    const bool same =
        ready.colours && ready.settings.colouring == settings.colouring &&
        ready.settings.look == settings.look && ready.tint == tint &&
        ready.settings.theme == settings.theme && ready.one == one &&
        (settings.colouring != MapColouring::Height || ready.poseInMap.isApprox(scan.poseInMap, 0.0)) &&
        (!content.ramp || ready.ramp == ramp);
    if (!same) {
        ready.settings = settings;
        ready.poseInMap = scan.poseInMap;
        ready.ramp = ramp;
        ready.one = one;
        ready.tint = tint;
        auto colours = coloursOf(*ready.points, settings, scan.poseInMap, ramp, one);
        const Rgba amber = mapColours(settings.theme).uncertain;
        if (tint > 0.0) {
            for (Rgba& colour : colours) colour = mixed(colour, amber, tint);
        }
        ready.colours = std::make_shared<const std::vector<Rgba>>(std::move(colours));
    }
    scan.look = {ready.colours, ready.shown};
}

bool SceneAssembler::addVoxels(SceneContent& content, const std::function<bool()>& interrupted) {
    VoxelRecipe recipe{.sources = {},
                       .size = std::clamp(content.settings.voxelSize, 0.05, 0.5),
                       .minHeight = content.settings.minHeight,
                       .maxHeight = content.settings.maxHeight,
                       .colouring = content.settings.colouring,
                       .ramp = content.ramp.value_or(ColourRamp{}),
                       .withCeiling = content.settings.withCeiling(),
                       .uncertain = mapColours(content.settings.theme).uncertain};
    for (std::size_t i = 0; i < content.scans.size(); ++i) {
        const SceneScan& scan = content.scans[i];
        if (!scan.visible) continue;
        const Rgba colour = colourOf(scan, i, content);
        recipe.sources.push_back({scan.points, scan.poseInMap.matrix(), i, colour, scan.uncertain});
    }
    if (!m_voxels || recipe != m_recipe) {
        auto mesh = buildVoxels(recipe, interrupted);
        if (!mesh) return false;
        m_voxels = std::make_shared<const VoxelMesh>(*std::move(mesh));
        m_recipe = std::move(recipe);
    }
    content.voxels = m_voxels;
    return true;
}

}  // namespace leitstand
