#include "app/session/report/report_files.h"

#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/io/ply.h"
#include "core/io/report/checksums.h"
#include "core/io/report/find_lists.h"
#include "core/io/report/geotiff.h"
#include "core/io/report/octomap_file.h"
#include "core/io/report/search_list.h"
#include "core/mission/report/file_names.h"
#include "core/scan/voxel_grid.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

Result<std::string> checkTiff(const fs::path& file) {
    const auto map = readGeoTiff(file);
    if (!map) return map.error();
    return fmt::format("{} x {} pixels of {:g} cm, georeferenced", map->picture.width, map->picture.height,
                       100 * map->perPixel);
}

Result<std::string> checkSearch(const fs::path& file) {
    const auto rows = readSearchList(file);
    if (!rows) return rows.error();
    return fmt::format("{} rows", rows->size());
}

Result<std::string> checkList(const fs::path& file) {
    const auto list = readFindList(file);
    if (!list) return list.error();
    return fmt::format("{} rows", list->finds.size());
}

Result<std::string> checkOctomap(const fs::path& file) {
    const auto tree = readOctomap(file);
    if (!tree) return tree.error();
    return fmt::format("{:g} m, {:.1f} m3 occupied, {:.1f} m3 free", tree->cell, tree->occupied, tree->free);
}

Result<std::string> checkCloud(const fs::path& file) {
    const auto cloud = readPly(file);
    if (!cloud) return cloud.error();
    if (cloud->scan.labels.size() != cloud->scan.points.size())
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected a label for each point"),
                                     file.string())};
    return fmt::format("{} points with labels", cloud->scan.points.size());
}

Result<std::string> checkTrajectory(const fs::path& file) {
    const auto poses = readTum(file);
    if (!poses) return poses.error();
    return fmt::format("{} poses", poses->size());
}

/// As far as a PDF can be checked without a reader of PDFs: its frame is whole.
Result<std::string> checkPdf(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    if (!in && bytes.empty())
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be opened"), file.string())};
    if (!bytes.starts_with("%PDF-"))
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected %PDF at its beginning"),
                                     file.string())};
    const auto place = bytes.rfind("startxref");
    if (place == std::string::npos || bytes.find("%%EOF", place) == std::string::npos)
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: expected its table of objects at the end"), file.string())};
    const auto at = std::strtoull(bytes.c_str() + place + 9, nullptr, 10);
    if (at >= bytes.size() || bytes.compare(at, 4, "xref") != 0)
        return Error{leitstand::fill(
            translate("leitstand::Error", "{}: its table of objects is not where it says"), file.string())};
    std::size_t pages = 0;
    for (auto page = bytes.find("/Type /Page\n"); page != std::string::npos;
         page = bytes.find("/Type /Page\n", page + 1))
        ++pages;
    return pages > 0 ? fmt::format("{} pages", pages) : fmt::format("{} bytes", bytes.size());
}

}  // namespace

Scan labelledCloud(const std::vector<ReportScan>& scans, double edge) {
    PointCloud cloud;
    for (const ReportScan& placed : scans) {
        const Scan& scan = *placed.scan;
        for (std::size_t i = 0; i < scan.points.size(); ++i) {
            if (!scan.points[i].allFinite()) continue;
            cloud.points.emplace_back((placed.scanInMap * scan.points[i].cast<double>()).cast<float>());
            cloud.labels.push_back(i < scan.labels.size() ? scan.labels[i] : Label::Unlabelled);
        }
    }
    if (edge > 0.0) cloud = voxelGrid(cloud, edge);
    Scan map;
    map.points = std::move(cloud.points);
    map.labels = std::move(cloud.labels);
    return map;
}

std::vector<TimedPose> trajectoryOf(const ReportRobot& robot) {
    std::vector<TimedPose> poses;
    for (const PathPose& pose : robot.path.poses) poses.push_back({pose.time, pose.baseInMap});
    return poses;
}

std::vector<std::string> trajectoryEndings(const std::vector<ReportRobot>& robots) {
    std::vector<std::string> endings;
    for (const ReportRobot& robot : robots) endings.push_back(robot.name);
    endings = fileNameParts(endings);
    for (std::string& ending : endings) ending = fmt::format("_{}.tum", ending);
    return endings;
}

Result<std::string> checkFile(const fs::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".tif") return checkTiff(file);
    if (file.filename().string().ends_with("_searched.csv")) return checkSearch(file);
    if (ending == ".csv") return checkList(file);
    if (ending == ".bt") return checkOctomap(file);
    if (ending == ".ply") return checkCloud(file);
    if (ending == ".tum") return checkTrajectory(file);
    if (ending == ".pdf") return checkPdf(file);
    if (file.filename() == "SHA256SUMS") {
        const auto names = checkChecksums(file.parent_path());
        if (!names) return names.error();
        return fmt::format("{} files as listed", names->size());
    }
    return Error{leitstand::fill(translate("leitstand::Error", "{}: is no file of a report"), file.string())};
}

}  // namespace leitstand
