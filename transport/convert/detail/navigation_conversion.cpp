#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/event/map_samples.h"
#include "core/event/motion_samples.h"
#include "messages/map_msgs.h"
#include "messages/nav_msgs.h"
#include "transport/convert/detail/conversion.h"

namespace leitstand::detail {
namespace {

constexpr double LargestCell = 100.0;  // [m]
constexpr int MostAcross = static_cast<int>(OccupancyGridSample::MostCells);

/// Checks that a rectangle of @p width times @p height has as many cells as were sent.
void checkCells(std::size_t width, std::size_t height, std::size_t cells, Checks& checks) {
    checks.require(width <= OccupancyGridSample::MostCells && height <= OccupancyGridSample::MostCells &&
                       width * height <= OccupancyGridSample::MostCells,
                   "width, height", "expected at most {} cells, found {} x {}",
                   OccupancyGridSample::MostCells, width, height);
    checks.require(!checks.ok() || width * height == cells, "data", "expected {} x {} cells, found {}", width,
                   height, cells);
}

void checkResolution(double resolution, std::size_t cells, Checks& checks) {
    checks.require(cells == 0 || (resolution > 0.0 && resolution <= LargestCell), "info.resolution",
                   "expected more than 0 and up to {} m, found {}", LargestCell, resolution);
}

}  // namespace

OccupancyGridSample fromWire(const wire::nav_msgs::OccupancyGrid& from, const Source&, Checks& checks) {
    OccupancyGridSample to;
    to.header = checks.header(from.header);
    to.loaded = checks.time("info.map_load_time", from.info.map_load_time);
    to.resolution = checks.finite("info.resolution", from.info.resolution);
    checkResolution(to.resolution, from.data.size(), checks);
    to.width = checks.size("info.width", from.info.width, MostAcross);
    to.height = checks.size("info.height", from.info.height, MostAcross);
    checkCells(from.info.width, from.info.height, from.data.size(), checks);
    to.gridInFrame = checks.poseOrPlace("info.origin", from.info.origin);
    to.cells = from.data;
    return to;
}

void toWire(const OccupancyGridSample& from, wire::nav_msgs::OccupancyGrid& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.info.map_load_time = checks.wireTime("info.map_load_time", from.loaded);
    to.info.resolution = static_cast<float>(checks.finite("info.resolution", from.resolution));
    checkResolution(from.resolution, from.cells.size(), checks);
    to.info.width = checks.wireSize("info.width", from.width);
    to.info.height = checks.wireSize("info.height", from.height);
    checkCells(to.info.width, to.info.height, from.cells.size(), checks);
    to.info.origin = checks.wirePose("info.origin", from.gridInFrame);
    to.data = from.cells;
}

GridUpdateSample fromWire(const wire::map_msgs::OccupancyGridUpdate& from, const Source&, Checks& checks) {
    GridUpdateSample to;
    to.header = checks.header(from.header);
    checks.require(from.x >= 0 && from.x <= MostAcross && from.y >= 0 && from.y <= MostAcross, "x, y",
                   "expected 0 to {}, found {}, {}", MostAcross, from.x, from.y);
    to.x = from.x;
    to.y = from.y;
    to.width = checks.size("width", from.width, MostAcross);
    to.height = checks.size("height", from.height, MostAcross);
    checkCells(from.width, from.height, from.data.size(), checks);
    to.cells = from.data;
    return to;
}

void toWire(const GridUpdateSample& from, wire::map_msgs::OccupancyGridUpdate& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.x = from.x;
    to.y = from.y;
    to.width = checks.wireSize("width", from.width);
    to.height = checks.wireSize("height", from.height);
    checkCells(to.width, to.height, from.cells.size(), checks);
    to.data = from.cells;
}

/// The poses have frames of their own, which no planner uses: they count as being in the path's.
PathSample fromWire(const wire::nav_msgs::Path& from, const Source&, Checks& checks) {
    PathSample to;
    to.header = checks.header(from.header);
    checks.require(from.poses.size() <= PathSample::MostPoses, "poses", "expected at most {}, found {}",
                   PathSample::MostPoses, from.poses.size());
    if (!checks.ok()) return to;
    to.posesInFrame.reserve(from.poses.size());
    for (const auto& one : from.poses) to.posesInFrame.push_back(checks.poseOrPlace("poses", one.pose));
    return to;
}

void toWire(const PathSample& from, wire::nav_msgs::Path& to, Buffer&, Checks& checks) {
    to.header = checks.wireHeader(from.header);
    to.poses.reserve(from.posesInFrame.size());
    for (const Pose& pose : from.posesInFrame)
        to.poses.push_back({to.header, checks.wirePose("poses", pose)});
}

std::vector<Conversion> navigationConversions() {
    return {
        conversion<wire::nav_msgs::OccupancyGrid, OccupancyGridSample>(),
        conversion<wire::map_msgs::OccupancyGridUpdate, GridUpdateSample>(),
        conversion<wire::nav_msgs::Path, PathSample>(),
    };
}

}  // namespace leitstand::detail
