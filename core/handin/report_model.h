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

/// When a robot changed to a mode.
struct ModeChange {
    Time time{};  ///< station's clock
    std::string mode;
    bool autonomous = false;
};

/// The input of a report, from the log.
struct ReportInput {
    std::string name;                 ///< name of the mission's folder
    std::vector<std::string> robots;  ///< names, in the order of the report
    MissionState state;               ///< state after the last event
    std::vector<ReportScan> scans;    ///< certain key scans, by rising id
    std::size_t uncertain = 0;        ///< number of uncertain scans about which nobody decided
    /// Of each robot, on its own clock, sorted by time.
    std::map<std::string, std::vector<PathPose>> odometry;
    std::map<std::string, std::vector<PathAnchor>>
        /// Poses of robots that were placed by laser; of each robot, on its own clock, sorted by time.
        places;
    std::map<std::string, std::vector<ModeChange>> modes;  ///< changes of mode of each robot, sorted by time
    std::vector<SearchView> views;  ///< poses from which cameras looked, each relative to a key scan
};

/// What a report says about the mission as a whole.
struct ReportFacts {
    std::string competition, team, country, mission, area, profile;  ///< may be empty, except `mission`
    std::uint32_t operators = 1;
    /// Times of the first event, and of the last event before any later review; station's clock; epoch: no
    /// events.
    Time begin{}, end{};
    std::chrono::nanoseconds duration{};  ///< from the mission's clock if it ran, otherwise from begin to end
    bool clocked = false;                 ///< whether the mission's clock ran
    std::uint64_t events = 0;
    std::vector<std::string> stations;  ///< "Leitstand 0.1.0 on kurts-laptop", each listed once
};

/// What a report says about a robot.
struct ReportRobot {
    std::string name;
    RobotPath path;                         ///< empty if its place is unknown
    double length = 0.0;                    ///< length of the path [m]
    std::size_t scans = 0;                  ///< number of its scans in the map
    std::chrono::nanoseconds autonomous{};  ///< time in modes in which it drove itself
    std::chrono::nanoseconds teleoperated{};
};

/// A victim or another find that is not discarded.
struct ReportFind {
    FindSample sample;
    std::string name;  ///< "V1"
    /// Position in the map, with the newest poses of scans [m].
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    double aboveFloor = 0.0;    ///< height above the floor [m]
    std::optional<int> storey;  ///< number of the storey on whose floor it is; empty: its place is unknown
    std::chrono::nanoseconds missionTime{};  ///< time from the mission's first event until it was found
    Way way;
};

/// One storey of a map with several storeys.
struct ReportStorey {
    StoreyShare share;
    std::vector<OccupancyGrid>
        grids;              ///< one for each of ReportModel::bands, relative to this storey's floor
    double explored = 0.0;  ///< explored area in the lower band [m2]
    ReportSearch search;    ///< search of its floor
};

/// The whole computed content of a report.
struct ReportModel {
    ReportFacts facts;
    std::vector<ReportRobot> robots;
    std::vector<ReportFind> finds;  ///< by kind and number
    std::size_t discarded = 0;      ///< number of discarded finds, which are not in `finds`
    std::size_t scans = 0, uncertain = 0;
    VoxelEvidence evidence;
    FloorHeights floor;
    std::vector<HeightBand> bands;  ///< heights that the maps show; never empty
    /// One for each of `bands`, with all storeys in one map seen from above.
    std::vector<OccupancyGrid> grids;
    double explored = 0.0;              ///< explored area of all storeys in the lower band [m2]
    ReportSearch search;                ///< search of all storeys
    std::vector<ReportStorey> storeys;  ///< from the lowest to the highest; empty when there is only one
    ReportWork work;

    [[nodiscard]] bool hasMap() const { return !evidence.empty(); }
};

/// Computes the report of @p input. Equal inputs give equal reports.
[[nodiscard]] ReportModel reportOf(const ReportInput& input, const Progress& progress = {});

/// One of the maps of a report.
struct ReportMap {
    std::size_t band = 0;            ///< index in ReportModel::bands
    std::optional<int> storey = {};  ///< number of one of ReportModel::storeys; empty: all storeys in one map
};
/// Returns the maps that together show all of @p model: one for each storey and each of its bands. If
/// there is a single storey, one per band. Empty without a map.
[[nodiscard]] std::vector<ReportMap> mapsOf(const ReportModel& model);

/// Returns the grid that @p map shows; its band and its storey are those of @p model.
[[nodiscard]] const OccupancyGrid& gridOf(const ReportModel& model, const ReportMap& map);

/// Returns the marks of all finds on @p storey, or on all storeys when @p storey is empty.
[[nodiscard]] std::vector<MapMark> marksOf(const ReportModel& model, std::optional<int> storey = {});

/// Returns @p map of @p model with all marks, as a drawing with @p title.
[[nodiscard]] MapDrawing drawingOf(const ReportModel& model, const ReportMap& map, std::string title);
/// Returns the map that shows the place of @p find at the height that stops robots.
[[nodiscard]] ReportMap mapAbout(const ReportModel& model, const ReportFind& find);

/// Returns the name of the hand-in for @p facts: "RoboCup2013-Team-Mission".
[[nodiscard]] std::string handInName(const ReportFacts& facts);

}  // namespace leitstand
