#include "app/services/handin/writing/report_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>
#include <system_error>

#include <fmt/format.h>

#include "core/base/words.h"
#include "core/cloud/filters/voxel_grid.h"
#include "core/handin/file_names.h"
#include "core/io/clouds/ply.h"
#include "core/io/clouds/scan_source.h"
#include "core/io/detail/numbers.h"
#include "core/io/handin/checksums.h"
#include "core/io/handin/find_lists.h"
#include "core/io/handin/geotiff.h"
#include "core/io/handin/grid_map.h"
#include "core/io/handin/octomap_file.h"
#include "core/io/handin/search_list.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

/// Returns @p found and @p what in words; error when @p file should have another number of them.
Result<std::string> counted(const fs::path& file, std::size_t found, const std::string& what,
                            const FileContents& expected) {
    if (expected.count && *expected.count != found)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected {} entries, found {}"),
                                     file.string(), *expected.count, found)};
    return fmt::format("{} {}", found, what);
}

Result<std::string> checkTiff(const fs::path& file, const FileContents& expected) {
    const auto map = readGeoTiff(file);
    if (!map) return map.error();
    if (const auto& frame = expected.frame) {
        const bool large = map->picture.width == frame->width && map->picture.height == frame->height;
        if (!large)
            return Error{leitstand::fill(
                translate("leitstand::Error", "{}: expected {} x {} pixels, found {} x {}"), file.string(),
                frame->width, frame->height, map->picture.width, map->picture.height)};
        const double off = std::max((map->topLeft - frame->topLeft).cwiseAbs().maxCoeff(),
                                    frame->width * std::abs(map->perPixel - frame->perPixel));
        if (!(off < 1e-6))
            return Error{leitstand::fill(translate("leitstand::Error",
                                                   "{}: expected its corner at x {:g}, y {:g} m with pixels "
                                                   "of {:g} m, found x {:g}, y {:g} m with {:g} m"),
                                         file.string(), frame->topLeft.x(), frame->topLeft.y(),
                                         frame->perPixel, map->topLeft.x(), map->topLeft.y(), map->perPixel)};
    }
    return fmt::format("{} x {} pixels of {:g} cm, georeferenced", map->picture.width, map->picture.height,
                       100 * map->perPixel);
}

Result<std::string> checkSearch(const fs::path& file, const FileContents& expected) {
    const auto rows = readSearchList(file);
    if (!rows) return rows.error();
    return counted(file, rows->size(), "rows", expected);
}

Result<std::string> checkList(const fs::path& file, const FileContents& expected) {
    const auto list = readFindList(file);
    if (!list) return list.error();
    return counted(file, list->finds.size(), "rows", expected);
}

Result<std::string> checkOctomap(const fs::path& file) {
    const auto tree = readOctomap(file);
    if (!tree) return tree.error();
    return fmt::format("{:g} m, {:.1f} m3 occupied, {:.1f} m3 free", tree->cell, tree->occupied, tree->free);
}

Result<std::string> checkGrid(const fs::path& image) {
    const auto grid = readGridMap(fs::path(image).replace_extension(".yaml"));
    if (!grid) return grid.error();
    return fmt::format("{} x {} cells of {:g} m, {:.1f} m2 explored", grid->columns, grid->rows, grid->cell,
                       exploredArea(*grid));
}

Result<std::string> checkCloud(const fs::path& file, const FileContents& expected) {
    const auto cloud = readPly(file);
    if (!cloud) return cloud.error();
    if (cloud->scan.labels.size() != cloud->scan.points.size())
        return Error{leitstand::fill(translate("leitstand::Error", "{}: expected a label for each point"),
                                     file.string())};
    return counted(file, cloud->scan.points.size(), "points with labels", expected);
}

Result<std::string> checkTrajectory(const fs::path& file, const FileContents& expected) {
    const auto poses = readTum(file);
    if (!poses) return poses.error();
    return counted(file, poses->size(), "poses", expected);
}

/// Checks a PDF as far as possible without a reader of PDFs: its frame is whole.
Result<std::string> checkPdf(const fs::path& file, const FileContents& expected) {
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
    if (expected.count && pages < *expected.count)
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: expected at least {} pages, found {}"),
                            file.string(), *expected.count, pages)};
    return pages > 0 ? fmt::format("{} pages", pages) : fmt::format("{} bytes", bytes.size());
}

/// How a written file is read again, by its ending.
struct FileCheck {
    std::string_view ending;
    Result<std::string> (*check)(const fs::path& file, const FileContents& expected);
};

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

FileContents contentsOf(const MapPicture& map) {
    return {.count = {},
            .frame = FileContents::Frame{map.picture.width, map.picture.height, map.topLeft, map.perPixel}};
}

bool isSearchList(const fs::path& file) {
    const std::string name = detail::lowerCase(file.filename().string());
    return name.ends_with("_searched.csv") || name == "searched.csv";
}

Result<std::string> checkFile(const fs::path& file, const FileContents& expected) {
    static constexpr auto Checks = std::to_array<FileCheck>({
        {".tif", &checkTiff},
        {".csv",
         [](const fs::path& list, const FileContents& contents) {
             return isSearchList(list) ? checkSearch(list, contents) : checkList(list, contents);
         }},
        {".bt", [](const fs::path& map, const FileContents&) { return checkOctomap(map); }},
        {".pgm", [](const fs::path& map, const FileContents&) { return checkGrid(map); }},
        {".ply", &checkCloud},
        {".tum", &checkTrajectory},
        {".pdf", &checkPdf},
    });
    const std::string ending = detail::lowerCase(file.extension().string());
    for (const FileCheck& one : Checks) {
        if (one.ending == ending) return one.check(file, expected);
    }
    if (file.filename() == "SHA256SUMS") {
        const auto names = checkChecksums(file.parent_path());
        if (!names) return names.error();
        return counted(file, names->size(), "files as listed", expected);
    }
    return Error{leitstand::fill(translate("leitstand::Error", "{}: is no file of a report"), file.string())};
}

Result<void> checkMapCloud(const fs::path& out, const std::vector<PlacedScan>& scans) {
    const auto echoes = [](const Scan& scan) {
        return static_cast<std::size_t>(std::count_if(
            scan.points.begin(), scan.points.end(),
            [](const Eigen::Vector3f& point) { return point.allFinite() && !point.isZero(0.0F); }));
    };
    const auto files = listScans({out});
    if (!files) return files.error();
    std::vector<std::size_t> expected;
    for (const PlacedScan& placed : scans) expected.push_back(echoes(*placed.scan));
    std::error_code ignored;
    if (!fs::is_directory(out, ignored))
        expected = {std::accumulate(expected.begin(), expected.end(), std::size_t{0})};
    if (files->size() != expected.size())
        return Error{
            fmt::format("{}: expected {} scans, found {}", out.string(), expected.size(), files->size())};
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const auto read = readScan((*files)[i]);
        if (!read) return read.error();
        if (const auto count = counted((*files)[i], echoes(read->scan), "points", {.count = expected[i]});
            !count)
            return count.error();
    }
    return {};
}

}  // namespace leitstand
