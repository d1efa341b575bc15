#include "core/handin/report_model.h"
#include "core/base/rotation/heading.h"
#include "core/event/find_sample.h"
#include "core/mission/finds/find_book.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "core/handin/file_names.h"
#include "core/mission/state/decision.h"
#include "core/mission/state/find_state.h"
#include "core/mission/state/mission_clock.h"
#include "core/mission/state/session_state.h"

namespace leitstand {
namespace {

using std::chrono::nanoseconds;

/// Returns when the mission ended. A review that files something days later belongs to it, but not to its
/// time.
Time endOf(const MissionState& state) {
    std::uint64_t newest = 0;  // newest sequence of a robot
    Time end{};
    for (const auto& [name, robot] : state.robots) {
        for (const auto& [topic, stream] : robot->streams) {
            newest = std::max(newest, stream.sequence);
            end = std::max(end, stream.received);
        }
    }
    const auto& sessions = *state.sessions;
    const auto later = std::find_if(sessions.begin(), sessions.end(),
                                    [&](const SessionState& session) { return session.started > newest; });
    if (newest == 0 || later == sessions.end()) return state.last;
    for (const Decision& decision : *state.decisions) {
        if (decision.sequence < later->started) end = std::max(end, decision.received);
    }
    return end;
}

ReportFacts factsOf(const ReportInput& input) {
    const MissionState& state = input.state;
    ReportFacts facts;
    facts.mission = input.name;
    facts.begin = state.first;
    facts.end = endOf(state);
    facts.events = state.events;
    facts.duration = facts.end - state.first;
    for (const SessionState& session : *state.sessions) {
        facts.operators = std::max<std::uint32_t>(1, session.session.operators);
        std::string words = fmt::format("Leitstand {}", session.session.version);
        if (!session.session.title.empty()) words += fmt::format(" on {}", session.session.title);
        if (std::find(facts.stations.begin(), facts.stations.end(), words) == facts.stations.end())
            facts.stations.push_back(std::move(words));
    }
    if (const MissionClock clock =
            clockAt(state.clock ? std::optional(state.clock->sample) : std::nullopt, facts.end);
        clock.elapsed > nanoseconds::zero()) {
        facts.duration = clock.elapsed;
        facts.clocked = true;
    }
    if (state.info) {
        const MissionInfoSample& info = state.info->sample;
        facts.competition = info.competition;
        facts.team = info.team;
        facts.country = info.country;
        if (!info.mission.empty()) facts.mission = info.mission;
        facts.operators = info.operators;
        facts.area = info.area;
        facts.profile = info.profile;
    }
    return facts;
}

std::vector<PathAnchor> anchorsOf(const ReportInput& input, const std::string& robot) {
    std::vector<PathAnchor> anchors;
    for (const ReportScan& scan : input.scans) {
        if (scan.scan->robot == robot) anchors.push_back({scan.scan->end, scan.baseInMap()});
    }
    if (const auto placed = input.places.find(robot); anchors.empty() && placed != input.places.end())
        anchors = placed->second;
    std::stable_sort(anchors.begin(), anchors.end(),
                     [](const PathAnchor& a, const PathAnchor& b) { return a.time < b.time; });
    return anchors;
}

ReportRobot robotOf(const ReportInput& input, const std::string& name) {
    ReportRobot robot;
    robot.name = name;
    robot.path.robot = name;
    const auto odometry = input.odometry.find(name);
    robot.path.poses =
        joinedPath(anchorsOf(input, name),
                   odometry == input.odometry.end() ? std::vector<PathPose>() : odometry->second);
    const auto known = input.state.robots.find(name);
    if (known != input.state.robots.end() && known->second->clockOffset) {
        const nanoseconds ahead = known->second->clockOffset->sample.ahead;
        for (PathPose& pose : robot.path.poses) pose.time -= ahead;
    }
    robot.length = robot.path.length();
    robot.scans = static_cast<std::size_t>(
        std::count_if(input.scans.begin(), input.scans.end(),
                      [&](const ReportScan& scan) { return scan.scan->robot == name; }));
    if (const auto modes = input.modes.find(name); modes != input.modes.end()) {
        const Time over = endOf(input.state);
        for (std::size_t i = 0; i < modes->second.size(); ++i) {
            const Time end = i + 1 < modes->second.size() ? modes->second[i + 1].time : over;
            const nanoseconds span = std::max(nanoseconds::zero(), nanoseconds(end - modes->second[i].time));
            (modes->second[i].autonomous ? robot.autonomous : robot.teleoperated) += span;
        }
    }
    return robot;
}

MapMark::Kind kindOf(const FindSample& find) {
    switch (find.kind) {
        case FindSample::Kind::Hazard:
            return MapMark::Kind::Hazard;
        case FindSample::Kind::Code:
            return MapMark::Kind::Code;
        case FindSample::Kind::Object:
            return MapMark::Kind::Object;
        case FindSample::Kind::Victim:
            break;
    }
    return find.status == FindSample::Status::Confirmed ? MapMark::Kind::Victim
                                                        : MapMark::Kind::UnconfirmedVictim;
}

/// Returns the number of the storey at height @p z of the map [m]; empty when there is only one.
std::optional<int> storeyAt(const ReportModel& model, double z) {
    for (const ReportStorey& one : model.storeys) {
        if (one.share.heights.hold(z)) return one.share.number;
    }
    return std::nullopt;
}

/// Returns the storey with @p number; null: there is none.
const ReportStorey* storeyOf(const ReportModel& model, std::optional<int> number) {
    const auto found = std::find_if(model.storeys.begin(), model.storeys.end(),
                                    [number](const ReportStorey& one) { return one.share.number == number; });
    return found == model.storeys.end() ? nullptr : &*found;
}

void addFinds(ReportModel& model, const MissionState& state) {
    std::vector<RobotPath> paths;
    for (const ReportRobot& robot : model.robots) paths.push_back(robot.path);
    const WayFinder ways(paths);
    for (const auto& [key, filed] : *state.finds) {
        const FindSample sample = wholeFind(state, key).value_or(filed.victim);
        if (sample.status == FindSample::Status::Discarded) {
            ++model.discarded;
            continue;
        }
        ReportFind find;
        find.sample = sample;
        find.name = nameOf(sample.kind, sample.number);
        find.position = positionInMap(state, sample);
        const double ground = model.floor.below(find.position);
        find.aboveFloor = find.position.z() - ground;
        if (find.position.allFinite()) find.storey = storeyAt(model, ground).value_or(0);
        find.missionTime = std::max(nanoseconds::zero(), nanoseconds(sample.found - state.first));
        if (find.position.allFinite())
            find.way = ways.to(find.position, gridOf(model, mapAbout(model, find)), model.floor);
        model.finds.push_back(std::move(find));
    }
}

/// Returns a grid above @p floor for each of the bands of @p model.
std::vector<OccupancyGrid> gridsOf(const ReportModel& model, const FloorHeights& floor) {
    std::vector<OccupancyGrid> grids;
    for (const HeightBand& band : model.bands)
        grids.push_back(model.evidence.empty() ? OccupancyGrid() : gridOf(model.evidence, floor, band));
    return grids;
}

/// Marks the cleared cells in the maps of all storeys in one. Each cell takes the value of the storey whose
/// floor it shows.
void markCleared(ReportModel& model) {
    std::vector<StoreyShare> shares;
    for (const ReportStorey& storey : model.storeys) shares.push_back(storey.share);
    for (std::size_t band = 0; band < model.grids.size(); ++band) {
        OccupancyGrid& grid = model.grids[band];
        for (std::size_t i = 0; i < grid.cells.size(); ++i) {
            if (grid.cells[i].state != OccupancyGrid::State::Free) continue;
            const auto columns = static_cast<std::size_t>(grid.columns);
            const double x = grid.origin.x() + grid.cell * (static_cast<double>(i % columns) + 0.5),
                         y = grid.origin.y() + grid.cell * (static_cast<double>(i / columns) + 0.5);
            const ReportStorey& shown = model.storeys[shareAt(shares, model.floor.at(x, y))];
            grid.cells[i].cleared = shown.grids[band].cells[i].cleared;
        }
    }
}

/// Adds what each storey shows and what of it was searched, and the same for all of them together.
void addStoreys(ReportModel& model, const ReportInput& input, std::span<const Eigen::Vector3d> ground) {
    const std::vector<StoreyCoverage> coverages = coverageOf(input.scans, input.views, ground);
    model.search = searchOf(coverages, input.views);
    if (coverages.size() == 1) {
        for (OccupancyGrid& grid : model.grids) markCleared(grid, *coverages.front().map);
        model.explored = exploredArea(model.grids.front());
        return;
    }
    for (const StoreyCoverage& one : coverages) {
        FloorSettings how;
        how.heights = one.storey.heights;
        ReportStorey storey;
        storey.share = one.storey;
        storey.grids = gridsOf(model, FloorHeights::of(input.scans, ground, how));
        for (OccupancyGrid& grid : storey.grids) markCleared(grid, *one.map);
        storey.explored = exploredArea(storey.grids.front());
        storey.search = searchOf({&one, 1}, input.views);
        model.explored += storey.explored;
        model.storeys.push_back(std::move(storey));
    }
    markCleared(model);
}

}  // namespace

ReportModel reportOf(const ReportInput& input, const Progress& progress) {
    ReportModel model;
    model.facts = factsOf(input);
    model.scans = input.scans.size();
    model.uncertain = input.uncertain;
    model.work = workOf(input.state);
    std::vector<Eigen::Vector3d> ground;
    for (const std::string& name : input.robots) {
        model.robots.push_back(robotOf(input, name));
        for (const PathPose& pose : model.robots.back().path.poses)
            ground.push_back(pose.baseInMap.translation());
    }
    model.evidence = VoxelEvidence::of(input.scans, {}, progress);
    model.floor = FloorHeights::of(input.scans, ground);
    model.bands = bandsOf(input.scans, model.floor);
    model.grids = gridsOf(model, model.floor);
    if (model.hasMap()) addStoreys(model, input, ground);
    addFinds(model, input.state);
    return model;
}

const OccupancyGrid& gridOf(const ReportModel& model, const ReportMap& map) {
    const ReportStorey* storey = storeyOf(model, map.storey);
    return (storey != nullptr ? storey->grids : model.grids).at(map.band);
}

std::vector<ReportMap> mapsOf(const ReportModel& model) {
    std::vector<ReportMap> maps;
    if (!model.hasMap()) return maps;
    const std::size_t bands = model.bands.size();
    for (std::size_t band = 0; model.storeys.empty() && band < bands; ++band) maps.push_back({band, {}});
    for (const ReportStorey& storey : model.storeys) {
        for (std::size_t band = 0; band < bands; ++band) maps.push_back({band, storey.share.number});
    }
    return maps;
}

std::vector<MapMark> marksOf(const ReportModel& model, std::optional<int> storey) {
    std::vector<MapMark> marks;
    for (const ReportFind& find : model.finds) {
        if (find.position.allFinite() && (!storey || find.storey == storey))
            marks.push_back({kindOf(find.sample), find.sample.number, find.position.head<2>()});
    }
    return marks;
}

MapDrawing drawingOf(const ReportModel& model, const ReportMap& map, std::string title) {
    MapDrawing drawing;
    drawing.title = std::move(title);
    drawing.grid = gridOf(model, map);
    const ReportStorey* storey = storeyOf(model, map.storey);
    const auto isShown = [storey](const PathPose& pose) {
        return storey == nullptr || storey->share.heights.hold(pose.baseInMap.translation().z());
    };
    for (const ReportRobot& robot : model.robots) {
        bool goesOn = false;
        for (const PathPose& pose : robot.path.poses) {
            if (!isShown(pose)) {
                goesOn = false;
                continue;
            }
            if (!goesOn || pose.afterGap) drawing.paths.emplace_back();
            drawing.paths.back().emplace_back(pose.baseInMap.translation().head<2>());
            goesOn = true;
        }
        if (robot.path.poses.empty() || !isShown(robot.path.poses.front())) continue;
        const Pose& first = robot.path.poses.front().baseInMap;
        drawing.starts.push_back({first.translation().head<2>(), headingOf(first)});
    }
    drawing.marks = marksOf(model, map.storey);
    return drawing;
}

ReportMap mapAbout(const ReportModel& model, const ReportFind& find) {
    return {0, model.storeys.empty() ? std::nullopt : find.storey};
}

std::string handInName(const ReportFacts& facts) {
    return handInName(facts.competition, facts.team, facts.mission);
}

}  // namespace leitstand
