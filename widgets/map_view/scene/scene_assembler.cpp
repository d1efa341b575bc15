#include "widgets/map_view/scene/scene_assembler.h"

#include <algorithm>
#include <chrono>
#include <limits>
#include <numeric>
#include <unordered_set>
#include <utility>

#include "widgets/map_view/scene/scene_statistics.h"

namespace leitstand {
namespace {

constexpr std::chrono::milliseconds PartInterval(150);

/// Returns the colour of all points of @p scan, the @p index -th of @p content, when the scan decides it.
Rgba colourOf(const SceneScan& scan, std::size_t index, const SceneContent& content) {
    switch (content.settings.colouring) {
        case MapColouring::Robot:
            return robotColour(content.robots[scan.robotAt].place, content.settings.theme);
        case MapColouring::Age:
            return onRamp(scan.age, content.ramp.value_or(ColourRamp{}));
        case MapColouring::Scan:
            return scanColour(index);
        case MapColouring::Label:
        case MapColouring::Height:
        case MapColouring::Range:
        case MapColouring::Intensity:
            break;
    }
    return {};
}

/// Returns how the points of @p scan, the @p index -th of @p content, are drawn. Its points must be ready.
PointCloudLook lookOf(const SceneScan& scan, std::size_t index, const SceneContent& content) {
    const MapViewSettings& settings = content.settings;
    const bool inQuestion = scan.uncertain && scan.id == content.inQuestion;
    PointPaint paint;
    paint.colouring = settings.colouring;
    paint.theme = settings.theme;
    paint.paleFloor = settings.look == MapLook::Top;
    paint.ramp = content.ramp.value_or(ColourRamp{});
    paint.one = colourOf(scan, index, content);
    paint.dim = content.changes || (content.inQuestion != 0 && !inQuestion);
    if (scan.uncertain) {
        const MapColours& colours = mapColours(settings.theme);
        paint.alike = true;
        paint.one = inQuestion  ? colours.scanInQuestion
                    : paint.dim ? dimmed(colours.uncertainScan, settings.theme)
                                : colours.uncertainScan;
    }
    if (settings.colouring == MapColouring::Height) {
        paint.up = scan.poseInMap.linear().row(2);
        paint.height = scan.poseInMap.translation().z();
    }
    return lookOf(*scan.points, paint, content.withCeiling(), scan.uncertain && !inQuestion);
}

/// Returns the look of points shown besides the map, all in @p colour.
PointCloudLook plainLookOf(const SceneScan& scan, const MapViewSettings& settings, Rgba colour) {
    PointPaint paint;
    paint.theme = settings.theme;
    paint.alike = true;
    paint.one = colour;
    return lookOf(*scan.points, paint, settings.withCeiling(), false);
}

/// Returns the new or the gone things of @p changes as points of small cubes. They stand out from the points
/// of the scans that saw them.
ScanPtr cubesOf(const MapChanges& changes, bool isNew) {
    constexpr float Half = 0.04F;  // of a cube [m]
    auto cubes = std::make_shared<Scan>();
    for (const ChangedThing& thing : changes.things) {
        if (thing.isNew != isNew) continue;
        for (const Eigen::Vector3f& cell : thing.cells) {
            for (const float x : {-Half, 0.0F, Half}) {
                for (const float y : {-Half, 0.0F, Half}) {
                    for (const float z : {-Half, 0.0F, Half})
                        cubes->points.push_back(cell + Eigen::Vector3f(x, y, z));
                }
            }
        }
    }
    cubes->labels.assign(cubes->points.size(), Label::Unlabelled);
    return cubes;
}

/// Returns when @p scan was received, on the station's clock, or else when it was taken, on its robot's
/// clock. Epoch: unknown.
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

/// Returns the index of @p robot in @p robots; adds it if it is missing.
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
    content.changes = order.changes != nullptr;
    content.robots = order.robots;
    if (!order.map) return content;
    for (std::size_t i = 0; i < order.map->scans.size(); ++i) {
        const MapScan& scan = order.map->scans[i];
        SceneScan shown;
        shown.name = scan.scan->name;
        shown.robot = scan.scan->robot;
        shown.robotAt = placeOf(shown.robot, content.robots);
        shown.entered = scan.entered;
        shown.id = scan.id;
        shown.uncertain = scan.uncertain;
        if (scan.uncertain && scan.id != 0 && scan.id == order.highlighted) content.inQuestion = scan.id;
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
        const SceneStatistics sample = statisticsOf(content);
        content.places = filledPlaces(sample);
        for (const SceneScan& scan : content.scans) {
            if (scan.visible && scan.points) content.places.emplace_back(scan.poseInMap.translation());
        }
        content.ramp = order.settings.colouring == MapColouring::Age
                           ? rampOfAges(content)
                           : rampOf(sample, order.settings.colouring);
        for (std::size_t i = 0; i < count && order.settings.look != MapLook::Voxels; ++i) {
            content.scans[i].look = lookOf(content.scans[i], i, content);
        }
    };
    Clock::time_point lastPart = Clock::now();
    for (std::size_t i = 0; i < content.scans.size(); ++i) {
        if (interrupted()) return nullptr;
        content.scans[i].points = pointsFor(order.map->scans[i].scan, order.settings);
        if (i + 1 == content.scans.size() || Clock::now() - lastPart < PartInterval) continue;
        finish(i + 1);
        content.complete = false;
        onPart(std::make_shared<const SceneContent>(content));
        content.complete = true;
        lastPart = Clock::now();
    }
    addGhosts(content, order);
    content.moves = !content.ghosts.empty();
    content.dragged = content.moves && order.dragged;
    addChanges(content, order);
    finish(content.scans.size());
    if (order.settings.look == MapLook::Voxels && !addVoxels(content, interrupted)) return nullptr;
    return std::make_shared<const SceneContent>(std::move(content));
}

void SceneAssembler::forgetAllBut(const Map& map) {
    std::unordered_set<const Scan*> kept;
    for (const MapScan& scan : map.scans) kept.insert(scan.scan.get());
    std::erase_if(m_ready, [&kept](const auto& ready) { return !kept.contains(ready.first); });
}

const ScanPointsPtr& SceneAssembler::pointsFor(const ScanPtr& scan, const MapViewSettings& settings) {
    Ready& ready = m_ready[scan.get()];
    if (!ready.points || ready.minRange != settings.minRange || ready.maxRange != settings.maxRange) {
        ready = Ready();
        ready.scan = scan;
        ready.minRange = settings.minRange;
        ready.maxRange = settings.maxRange;
        ready.points =
            std::make_shared<const ScanPoints>(drawablePoints(scan, settings.minRange, settings.maxRange));
    }
    return ready.points;
}

void SceneAssembler::addGhosts(SceneContent& content, const SceneOrder& order) {
    for (const SceneScan& scan : content.scans) {
        const auto place = order.ghosts.find(scan.id);
        if (place == order.ghosts.end() || !scan.visible) continue;
        SceneScan& ghost = content.ghosts.emplace_back(scan);
        ghost.poseInMap = place->second;
        ghost.look = plainLookOf(ghost, order.settings, mapColours(order.settings.theme).scanInQuestion);
    }
}

void SceneAssembler::addChanges(SceneContent& content, const SceneOrder& order) {
    if (order.changes != m_changed) {
        m_changed = order.changes;
        for (const bool isNew : {true, false}) {
            ScanPointsPtr& points = m_changedPoints[isNew ? 0 : 1];
            points = nullptr;
            if (!m_changed) continue;
            constexpr double Everything = std::numeric_limits<double>::infinity();
            const ScanPtr cubes = cubesOf(*m_changed, isNew);
            if (!cubes->points.empty())
                points = std::make_shared<const ScanPoints>(drawablePoints(cubes, 0.0, Everything));
        }
    }
    const MapColours& colours = mapColours(order.settings.theme);
    for (const bool isNew : {true, false}) {
        const ScanPointsPtr& points = m_changedPoints[isNew ? 0 : 1];
        if (!points) continue;
        SceneScan& shown = content.ghosts.emplace_back();
        shown.points = points;
        shown.look = plainLookOf(shown, order.settings, isNew ? colours.newThing : colours.goneThing);
    }
}

bool SceneAssembler::addVoxels(SceneContent& content, const std::function<bool()>& interrupted) {
    VoxelRecipe recipe{.sources = {},
                       .size = std::clamp(content.settings.voxelSize, 0.05, 0.5),
                       .minHeight = content.settings.minHeight,
                       .maxHeight = content.settings.maxHeight,
                       .colouring = content.settings.colouring,
                       .ramp = content.ramp.value_or(ColourRamp{}),
                       .withCeiling = content.withCeiling(),
                       .theme = content.settings.theme,
                       .changes = content.changes,
                       .came = m_changedPoints[0],
                       .went = m_changedPoints[1]};
    for (std::size_t i = 0; i < content.scans.size(); ++i) {
        const SceneScan& scan = content.scans[i];
        if (!scan.visible) continue;
        const Rgba colour = colourOf(scan, i, content);
        if (scan.uncertain && scan.id == content.inQuestion) recipe.inQuestion = i;
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
