#include "app/services/handin/writing/mission_export.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "app/services/handin/finds/find_tables.h"
#include "app/services/handin/report_source.h"
#include "app/services/handin/writing/report_files.h"
#include "core/handin/file_names.h"
#include "core/io/clouds/cloud_formats.h"
#include "core/io/clouds/cloud_writer.h"
#include "core/io/detail/numbers.h"
#include "core/io/handin/geotiff.h"
#include "core/io/handin/grid_map.h"
#include "core/io/handin/octomap_file.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

std::string endingOf(const fs::path& out) {
    return detail::lowerCase(out.extension().string());
}

bool isFolder(const fs::path& out) {
    std::error_code ignored;
    return !out.has_filename() || fs::is_directory(out, ignored);
}

ReportFile fileOf(const fs::path& file, std::string check) {
    std::error_code ignored;
    const auto bytes = fs::is_regular_file(file, ignored) ? fs::file_size(file, ignored) : 0;
    return {.name = file.string(), .bytes = bytes, .whole = true, .check = std::move(check)};
}

/// Reads the file that was @p written again.
Result<ReportFile> again(const Result<void>& written, const fs::path& file,
                         const FileContents& contents = {}) {
    if (!written) return written.error();
    const auto check = checkFile(file, contents);
    if (!check) return check.error();
    return fileOf(file, *check);
}

Result<ReportFile> exportCloud(const fs::path& out, const ReportInput& input, double reduce) {
    std::vector<PlacedScan> placed;
    if (reduce > 0.0 && !isFolder(out)) {
        placed.push_back(
            {std::make_shared<const Scan>(labelledCloud(input.scans, reduce)), Pose::Identity()});
    } else {
        for (const ReportScan& scan : input.scans) placed.push_back({scan.scan, scan.scanInMap});
    }
    if (const auto written = writeMapCloud(out, placed); !written) return written.error();
    if (const auto check = checkMapCloud(out, placed); !check) return check.error();
    std::size_t points = 0;
    for (const PlacedScan& scan : placed) points += scan.scan->points.size();
    return fileOf(out, fmt::format("{} points of {} scans", points, input.scans.size()));
}

FindList::Kind listKind(const fs::path& out) {
    const std::string name = detail::lowerCase(out.filename().string());
    for (const auto kind : {FindList::Kind::Victims, FindList::Kind::Codes}) {
        const std::string ending = endingOf(kind);
        if (name.ends_with(ending) || name == ending.substr(1)) return kind;
    }
    return FindList::Kind::Pois;
}

Result<ExportOutcome> exportTrajectories(const fs::path& out, const ReportModel& model,
                                         const std::string& robot) {
    ExportOutcome outcome;
    std::vector<std::size_t> robots;
    for (std::size_t i = 0; i < model.robots.size(); ++i) {
        const ReportRobot& one = model.robots[i];
        if (!one.path.poses.empty() && (robot.empty() || one.name == robot)) robots.push_back(i);
    }
    if (robots.empty()) {
        return Error{fmt::format("{}: is not written: nobody knows the way of {} in the map", out.string(),
                                 robot.empty() ? "any robot" : robot)};
    }
    const std::vector<std::string> endings = trajectoryEndings(model.robots);
    for (const std::size_t one : robots) {
        fs::path file = out;
        if (robots.size() > 1) file.replace_filename(out.stem().string() + endings[one]);
        const auto poses = trajectoryOf(model.robots[one]);
        auto written = again(writeTum(file, poses), file, {.count = poses.size()});
        if (!written) return written.error();
        outcome.files.push_back(std::move(written).value());
    }
    return outcome;
}

/// Error when @p model does not have the storey that @p map is to show.
Result<void> hasMap(const ReportModel& model, const ReportMap& map, const fs::path& out) {
    std::vector<int> numbers;
    for (const ReportStorey& storey : model.storeys) numbers.push_back(storey.share.number);
    if (numbers.empty()) numbers.push_back(0);
    if (!map.storey || std::find(numbers.begin(), numbers.end(), *map.storey) != numbers.end()) return {};
    return Error{fmt::format("{}: is not written: expected one of the storeys {}, found {}", out.string(),
                             fmt::join(numbers, ", "), *map.storey)};
}

/// What an export is made of.
struct Exported {
    const ReportInput& input;
    const ReportModel& model;
    const ExportOptions& options;
};

Result<ExportOutcome> oneFile(Result<ReportFile> file) {
    if (!file) return file.error();
    ExportOutcome outcome;
    outcome.files.push_back(std::move(file).value());
    return outcome;
}

Result<ReportMap> shownMap(const fs::path& out, const Exported& from) {
    const ReportMap shown{from.options.upper ? std::size_t{1} : std::size_t{0}, from.options.storey};
    if (shown.band >= from.model.bands.size())
        return Error{fmt::format("{}: is not written: all scans are of plane lasers, expected --height low",
                                 out.string())};
    if (const auto known = hasMap(from.model, shown, out); !known) return known.error();
    return shown;
}

Result<ExportOutcome> exportGrid(const fs::path& out, const Exported& from) {
    const auto shown = shownMap(out, from);
    if (!shown) return shown.error();
    auto image = again(writeGridMap(out, gridOf(from.model, *shown)), out);
    if (!image) return image.error();
    ExportOutcome outcome;
    outcome.files.push_back(std::move(image).value());
    outcome.files.push_back(fileOf(fs::path(out).replace_extension(".yaml"), "for map_server"));
    return outcome;
}

Result<ExportOutcome> exportMap(const fs::path& out, const Exported& from) {
    const auto known = shownMap(out, from);
    if (!known) return known.error();
    const ReportMap& shown = *known;
    const MapPicture map = paintMap(drawingOf(from.model, shown, out.filename().string()));
    return oneFile(again(writeGeoTiff(out, map), out, contentsOf(map)));
}

Result<ExportOutcome> exportList(const fs::path& out, const Exported& from) {
    if (isSearchList(out)) {
        const std::vector<ListedSearch> rows = searchListOf(from.model);
        return oneFile(again(writeSearchList(out, rows), out, {.count = rows.size()}));
    }
    const FindList list = listOf(from.model, listKind(out));
    return oneFile(again(writeFindList(out, list), out, {.count = list.finds.size()}));
}

/// A format made from the report's model; clouds have their own table (CloudFormat).
struct ModelFormat {
    std::string_view ending, subject;
    bool showsMap = false;  ///< needs a scan that counts
    Result<ExportOutcome> (*write)(const fs::path& out, const Exported& from);
};
constexpr auto ModelFormats = std::to_array<ModelFormat>({
    {".bt", "OctoMap", true,
     [](const fs::path& out, const Exported& from) {
         return oneFile(again(writeOctomap(out, from.model.evidence), out));
     }},
    {".pgm", "grid map with NAME.yaml", true, &exportGrid},
    {".tif", "GeoTIFF", true, &exportMap},
    {".tum", "trajectory", false,
     [](const fs::path& out, const Exported& from) {
         return exportTrajectories(out, from.model, from.options.robot);
     }},
    {".csv", "list", false, &exportList},
});

const ModelFormat* modelFormatOf(const fs::path& out) {
    const std::string ending = endingOf(out);
    const auto* const found = std::find_if(ModelFormats.begin(), ModelFormats.end(),
                                           [&](const ModelFormat& one) { return one.ending == ending; });
    return found != ModelFormats.end() ? found : nullptr;
}

bool isCloud(const fs::path& out) {
    const CloudFormat* const format = cloudFormatOf(out);
    return isFolder(out) || (format != nullptr && format->write != nullptr);
}

Result<ExportOutcome> exportInto(const fs::path& out, const ReportInput& input, const ExportOptions& options,
                                 const Progress& progress) {
    const Error cancelled{out.string() + ": is not written: cancelled"};
    if (progress.cancelled()) return cancelled;
    const ModelFormat* const format = isCloud(out) ? nullptr : modelFormatOf(out);
    if ((format == nullptr || format->showsMap) && input.scans.empty())
        return Error{out.string() + ": is not written: no scan of the mission counts"};
    if (format == nullptr) return oneFile(exportCloud(out, input, options.reduce));
    const ReportModel model = reportOf(input, progress);
    if (progress.cancelled()) return cancelled;
    return format->write(out, {input, model, options});
}

}  // namespace

std::vector<ExportFormat> exportFormats() {
    std::vector<ExportFormat> formats;
    for (const CloudFormat& cloud : cloudFormats()) {
        if (cloud.write != nullptr) formats.push_back({std::string(cloud.ending), "points"});
    }
    for (const ModelFormat& format : ModelFormats)
        formats.push_back({std::string(format.ending), std::string(format.subject)});
    return formats;
}

bool canExport(const fs::path& out) {
    return isCloud(out) || modelFormatOf(out) != nullptr;
}

bool showsStoreys(const fs::path& out) {
    const ModelFormat* const format = isCloud(out) ? nullptr : modelFormatOf(out);
    return format != nullptr && (format->write == &exportMap || format->write == &exportGrid);
}

std::string expectedOfExport() {
    std::string expected = "expected an ending";
    for (const ExportFormat& format : exportFormats()) expected += " " + format.ending;
    return expected + ", or a folder that ends in /";
}

Result<ExportOutcome> exportMission(const fs::path& mission, const fs::path& out,
                                    const ExportOptions& options, const Progress& progress) {
    if (!canExport(out)) return Error{out.string() + ": " + expectedOfExport()};
    auto source = ReportSource::open(mission, progress);
    if (!source) return source.error();
    auto outcome = exportInto(out, source->input(), options, progress);
    if (!outcome) return outcome;
    ExportOutcome done = std::move(outcome).value();
    done.warnings = source->warnings();
    return done;
}

}  // namespace leitstand
