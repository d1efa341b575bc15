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
    std::vector<ReportScan> scans;    ///< key scans that count in the map, by rising id
    std::size_t uncertain = 0;        ///< number of scans that do not count because nobody decided on them
    std::map<std::string, std::vector<PathPose>> odometry;  ///< of each robot, robot's clock, sorted by time
    std::map<std::string, std::vector<PathAnchor>>
        places;  ///< poses at which robots were placed by laser; of each robot, robot's clock, sorted by time
    std::map<std::string, std::vector<ModeChange>> modes;  ///< of each robot, sorted by time
    std::vector<SearchView> views;  ///< poses from which cameras looked, each relative to a key scan
};

/// What a report states about the mission as a whole.
struct ReportFacts {
    std::string competition, team, country, mission, area, profile;  ///< may be empty, except mission
    std::uint32_t operators = 1;
    /// First event, and last one before any later review; station's clock; epoch: no events.
    Time begin{}, end{};
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
    std::size_t scans = 0;                  ///< number of its scans that are in the map
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
    std::chrono::nanoseconds missionTime{};  ///< from the first event of the mission until it was found
    Way way;
};

/// A storey of a map that has several.
struct ReportStorey {
    StoreyShare share;
    std::vector<OccupancyGrid> grids;  ///< one for each of ReportModel::bands, above this storey's floor
    double explored = 0.0;             ///< area at the lower height [m2]
    ReportSearch search;               ///< of its floor
};

/// The whole content of a report, computed.
struct ReportModel {
    ReportFacts facts;
    std::vector<ReportRobot> robots;
    std::vector<ReportFind> finds;  ///< by kind and number
    std::size_t discarded = 0;      ///< number of discarded finds, which are not in finds
    std::size_t scans = 0, uncertain = 0;
    VoxelEvidence evidence;
    FloorHeights floor;
    std::vector<HeightBand> bands;      ///< heights that its maps show; never empty
    std::vector<OccupancyGrid> grids;   ///< one for each of `bands`; all storeys in one, seen from above
    double explored = 0.0;              ///< area at the lower height, of all storeys [m2]
    ReportSearch search;                ///< of all storeys
    std::vector<ReportStorey> storeys;  ///< from the lowest on; empty when there is only one
    ReportWork work;

    [[nodiscard]] bool hasMap() const { return !evidence.empty(); }
};

/// Returns the report of @p input; equal inputs make equal reports.
[[nodiscard]] ReportModel reportOf(const ReportInput& input, const Progress& progress = {});

/// One of the maps of a report.
struct ReportMap {
    std::size_t band = 0;            ///< index into ReportModel::bands
    std::optional<int> storey = {};  ///< number of one of ReportModel::storeys; empty: all in one
};
/// Returns the maps that together show all of @p model: one for each storey and each of its bands. A
/// model with a single storey has one per band. Empty without a map.
[[nodiscard]] std::vector<ReportMap> mapsOf(const ReportModel& model);

/// Returns the grid that @p map shows; its band and its storey are those of @p model.
[[nodiscard]] const OccupancyGrid& gridOf(const ReportModel& model, const ReportMap& map);

/// Returns the marks of all finds on @p storey, or on all storeys when @p storey is empty.
[[nodiscard]] std::vector<MapMark> marksOf(const ReportModel& model, std::optional<int> storey = {});

/// Returns @p map of @p model with everything that is marked in it.
[[nodiscard]] MapDrawing drawingOf(const ReportModel& model, const ReportMap& map, std::string title);
/// Returns the map that shows the place of @p find at the height that stops robots.
[[nodiscard]] ReportMap mapAbout(const ReportModel& model, const ReportFind& find);

/// Returns the name of the hand-in by @p facts: "RoboCup2013-Team-Mission".
[[nodiscard]] std::string handInName(const ReportFacts& facts);

}  // namespace leitstand
