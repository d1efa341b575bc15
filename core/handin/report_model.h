#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/progress.h"
#include "core/event/find_sample.h"
#include "core/handin/map/map_drawing.h"
#include "core/handin/map/robot_path.h"
#include "core/handin/map/voxel_evidence.h"
#include "core/handin/map/ways.h"
#include "core/handin/report_search.h"
#include "core/handin/report_work.h"
#include "core/mapping/floor_heights.h"
#include "core/mapping/report_scan.h"
#include "core/mapping/storeys.h"
#include "core/mission/state/mission_state.h"

namespace leitstand {

/// The time at which a robot entered a mode.
struct ModeChange {
    Time time{};  ///< station's clock
    std::string mode;
    bool autonomous = false;
};

/// The input of a report, as the log has it.
struct ReportInput {
    std::string name;                 ///< of the mission's folder
    std::vector<std::string> robots;  ///< names, in the order of the report
    MissionState state;               ///< after the last event
    std::vector<ReportScan> scans;    ///< that count, by rising id
    std::size_t uncertain = 0;        ///< scans that do not count, since nobody decided on them
    std::map<std::string, std::vector<PathPose>> odometry;  ///< by robot, robot's clock, by time
    std::map<std::string, std::vector<PathAnchor>>
        places;  ///< poses of robots that were placed by laser; by robot, robot's clock, by time
    std::map<std::string, std::vector<ModeChange>> modes;  ///< by time
    std::vector<SearchView> views;                         ///< where cameras looked from, hung on scans
};

/// What a report states about the mission as a whole.
struct ReportFacts {
    std::string competition, team, country, mission, area, profile;  ///< may be empty, except mission
    std::uint32_t operators = 1;
    Time begin{}, end{};                  ///< first and last event, station's clock; epoch: no events
    std::chrono::nanoseconds duration{};  ///< by the mission's clock when it ran, otherwise from begin to end
    bool clocked = false;                 ///< whether the mission's clock ran
    std::uint64_t events = 0;
    std::vector<std::string> stations;  ///< "Leitstand 0.1.0 on kurts-laptop", each once
};

/// What a report states about a robot.
struct ReportRobot {
    std::string name;
    RobotPath path;                         ///< empty when its place is unknown
    double length = 0.0;                    ///< of the path [m]
    std::size_t scans = 0;                  ///< that are in the map
    std::chrono::nanoseconds autonomous{};  ///< time in modes in which it drives itself
    std::chrono::nanoseconds teleoperated{};
};

/// A victim or another find that is not discarded.
struct ReportFind {
    FindSample sample;
    std::string name;                                    ///< "V1"
    Eigen::Vector3d position = Eigen::Vector3d::Zero();  ///< in the map, with the newest poses of scans [m]
    double aboveFloor = 0.0;                             ///< [m]
    std::optional<int> storey;  ///< number of the storey whose floor it is above; empty: its place is unknown
    std::chrono::nanoseconds missionTime{};  ///< from the mission's begin until it was found
    Way way;
};

/// A storey of a map that has several.
struct ReportStorey {
    StoreyShare share;
    std::vector<OccupancyGrid> grids;  ///< one for each of reportBands(), above this storey's floor
    double explored = 0.0;             ///< area at the lower height [m2]
    ReportSearch search;               ///< of its floor
};

/// The whole content of a report, computed.
struct ReportModel {
    ReportFacts facts;
    std::vector<ReportRobot> robots;
    std::vector<ReportFind> finds;  ///< by kind and number
    std::size_t discarded = 0;      ///< finds that are not in it
    std::size_t scans = 0, uncertain = 0;
    VoxelEvidence evidence;
    FloorHeights floor;
    std::vector<OccupancyGrid> grids;  ///< one for each of reportBands(); all storeys in one, seen from above
    double explored = 0.0;             ///< area at the lower height, of all storeys [m2]
    ReportSearch search;               ///< of all storeys
    std::vector<ReportStorey> storeys;  ///< from the lowest on; empty when there is only one
    ReportWork work;

    [[nodiscard]] bool hasMap() const { return !evidence.empty(); }
};

/// Returns the report of @p input; equal inputs make equal reports.
[[nodiscard]] ReportModel reportOf(const ReportInput& input, const Progress& progress = {});

/// One of the maps of a report.
struct ReportMap {
    std::size_t band = 0;            ///< of reportBands()
    std::optional<int> storey = {};  ///< number of one of ReportModel::storeys; empty: all in one
};
/// Returns the maps of all places of @p model, with each place once for each height. They are those of its
/// storeys, or of the only one; none without a map.
[[nodiscard]] std::vector<ReportMap> mapsOf(const ReportModel& model);

/// Returns the marks of what was found for a map of @p storey, or of all storeys.
[[nodiscard]] std::vector<MapMark> marksOf(const ReportModel& model, std::optional<int> storey = {});

/// Returns @p map of @p model with everything that is marked in it.
[[nodiscard]] MapDrawing drawingOf(const ReportModel& model, const ReportMap& map, std::string title);
/// Returns the map that shows the place of @p find at the height that stops robots.
[[nodiscard]] ReportMap mapAbout(const ReportModel& model, const ReportFind& find);

/// Returns the name of the hand-in by @p facts: "RoboCup2013-Team-Mission".
[[nodiscard]] std::string handInName(const ReportFacts& facts);

}  // namespace leitstand
