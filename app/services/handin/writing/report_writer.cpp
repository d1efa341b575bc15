#include "app/services/handin/writing/report_writer.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/services/handin/finds/find_pages.h"
#include "app/services/handin/finds/find_tables.h"
#include "app/services/handin/report_source.h"
#include "app/services/handin/writing/earlier_report.h"
#include "app/services/handin/writing/report_files.h"
#include "app/services/progress_part.h"
#include "core/base/time.h"
#include "core/base/words.h"
#include "core/event/find_sample.h"
#include "core/handin/file_names.h"
#include "core/io/clouds/ply.h"
#include "core/io/detail/output_file.h"
#include "core/io/handin/checksums.h"
#include "core/io/handin/geotiff.h"
#include "core/io/handin/octomap_file.h"
#include "core/io/handin/search_list.h"
#include "core/io/settings/score_file.h"
#include "core/mission/state/find_state.h"

namespace leitstand {
namespace {

namespace fs = std::filesystem;

constexpr double CloudEdge = 0.02;       ///< of the cubes that keep a point in the PLY [m]
constexpr double PrintedPixels = 3.0e6;  ///< of a map in the PDF

/// Result of writing a file, and what the file should contain.
struct Written {
    Result<void> written;
    FileContents contents = {};
};

/// Writes the files of one report. When one fails the others are still written, unless the report is
/// cancelled.
class Writing {
public:
    Writing(fs::path folder, std::string name, const Progress& progress)
        : m_folder(std::move(folder)), m_name(std::move(name)), m_progress(progress) {}

    template <class Write>
    void file(const std::string& ending, Write write) {
        if (m_progress.cancelled()) {
            m_failure = Error{leitstand::fill(translate("leitstand::Error", "{}: the report was cancelled"),
                                              m_folder.string())};
            return;
        }
        const std::string name = ending == "SHA256SUMS" ? ending : m_name + ending;
        if (const Written done = write(m_folder / name); !done.written) {
            if (!m_failure) m_failure = done.written.error();
        } else {
            m_names.push_back(name);
            m_contents.push_back(done.contents);
        }
    }
    /// What the file of number @p index of names() should contain.
    [[nodiscard]] const FileContents& contents(std::size_t index) const { return m_contents[index]; }
    [[nodiscard]] const std::optional<Error>& failure() const { return m_failure; }
    [[nodiscard]] const std::vector<std::string>& names() const { return m_names; }
    [[nodiscard]] const fs::path& folder() const { return m_folder; }
    [[nodiscard]] const std::string& name() const { return m_name; }

private:
    fs::path m_folder;
    std::string m_name;
    std::vector<std::string> m_names;
    std::vector<FileContents> m_contents;
    const Progress& m_progress;
    std::optional<Error> m_failure;  ///< the first
};

void writeMaps(Writing& writing, const ReportModel& model) {
    if (!model.hasMap()) return;
    std::vector<ReportMap> maps;  // the rules require one with everything
    for (std::size_t band = 0; band < model.bands.size(); ++band) maps.push_back({band, {}});
    if (!model.storeys.empty()) {
        for (const ReportMap& one : mapsOf(model)) maps.push_back(one);
    }
    for (const ReportMap& one : maps) {
        const std::string storey = one.storey ? fmt::format("_storey{}", *one.storey) : std::string();
        writing.file(storey + (one.band == 0 ? ".tif" : "_upper.tif"), [&](const fs::path& file) -> Written {
            const MapPicture map = paintMap(drawingOf(model, one, file.filename().string()));
            return {writeGeoTiff(file, map), contentsOf(map)};
        });
    }
}

void writeLists(Writing& writing, const ReportModel& model) {
    for (const auto kind : {FindList::Kind::Victims, FindList::Kind::Codes, FindList::Kind::Pois}) {
        writing.file(endingOf(kind), [&](const fs::path& file) -> Written {
            const FindList list = listOf(model, kind);
            return {writeFindList(file, list), {.count = list.finds.size()}};
        });
    }
}

void writeSearch(Writing& writing, const ReportModel& model) {
    if (model.search.sensors.empty()) return;
    writing.file("_searched.csv", [&](const fs::path& file) -> Written {
        const std::vector<ListedSearch> rows = searchListOf(model);
        return {writeSearchList(file, rows), {.count = rows.size()}};
    });
}

void writeClouds(Writing& writing, const ReportModel& model, const ReportInput& input) {
    if (!model.hasMap()) return;
    writing.file(".bt",
                 [&](const fs::path& file) -> Written { return {writeOctomap(file, model.evidence)}; });
    writing.file(".ply", [&](const fs::path& file) -> Written {
        const Scan cloud = labelledCloud(input.scans, CloudEdge);
        return {writePly(file, cloud), {.count = cloud.points.size()}};
    });
    const std::vector<std::string> endings = trajectoryEndings(model.robots);
    for (std::size_t i = 0; i < endings.size(); ++i) {
        const auto poses = trajectoryOf(model.robots[i]);
        if (poses.empty()) continue;
        writing.file(endings[i], [&](const fs::path& file) -> Written {
            return {writeTum(file, poses), {.count = poses.size()}};
        });
    }
}

ReportContent contentOf(ReportModel model, ReportSource& source, const ReportOptions& options,
                        std::vector<std::string>& warnings, const Progress& progress) {
    ReportContent content;
    content.name = handInName(model.facts);
    content.version = options.version;
    content.created = options.created;
    if (content.created == Time{})
        content.created = Time(std::chrono::system_clock::now().time_since_epoch());
    for (const ReportMap& map : mapsOf(model)) {
        if (progress.cancelled()) break;
        PaintSettings settings;
        settings.title = settings.names = false;  // the page has them, in letters
        settings.mostPixels = PrintedPixels;
        content.maps.push_back({map, paintMap(drawingOf(model, map, ""), settings)});
    }
    for (const ReportFind& find : model.finds) {
        if (progress.cancelled()) break;
        content.finds.push_back(pagesOf(find, model, source, warnings));
    }
    const ScoreProfiles profiles = scoreProfiles();
    if (const ScoreProfile* profile = profiles.find(model.facts.profile)) {
        content.profile = *profile;
        content.score = score(*profile, source.input().state, footprintsOf(source.robots()));
        if (!model.facts.profile.empty() && profile->name != model.facts.profile) {
            warnings.push_back(leitstand::fill(
                translate("leitstand::ReportText", "the score's profile \"{}\" is not there: \"{}\" is used"),
                model.facts.profile, profile->name));
        }
    }
    content.changes = changesOf(source.input().scans, {}, part(progress, 0.8, 0.9));
    content.model = std::move(model);
    content.warnings = warnings;
    return content;
}

void warnOfMissing(const ReportModel& model, bool mentionsMap, std::vector<std::string>& warnings) {
    std::string unconfirmed;
    for (const ReportFind& find : model.finds) {
        if (find.sample.status == FindSample::Status::Confirmed) continue;
        unconfirmed += fmt::format("{}{}", unconfirmed.empty() ? "" : ", ", find.name);
    }
    if (!model.hasMap() && !mentionsMap)
        warnings.push_back(
            translate("leitstand::ReportText", "there is no map: no scan of the mission counts"));
    if (!model.hasMap())
        warnings.push_back(
            translate("leitstand::ReportText",
                      "without a map there are no GeoTIFF, OctoMap, PLY and pages of the map"));
    if (!unconfirmed.empty())
        warnings.push_back(
            fill(translate("leitstand::ReportText", "not confirmed, so in the map but not in the lists: {}"),
                 unconfirmed));
    if (model.facts.team.empty() || model.facts.competition.empty())
        warnings.push_back(
            translate("leitstand::ReportText",
                      "competition or team are not given: the files are named for what is missing"));
}

std::vector<ReportFile> checked(const Writing& writing, const Progress& progress) {
    std::vector<ReportFile> files;
    for (const std::string& name : writing.names()) {
        if (progress.cancelled()) break;
        ReportFile file;
        file.name = name;
        std::error_code ignored;
        file.bytes = fs::file_size(writing.folder() / name, ignored);
        const auto check = checkFile(writing.folder() / name, writing.contents(files.size()));
        file.whole = check.ok();
        file.check = check ? *check : check.error().text;
        files.push_back(std::move(file));
    }
    return files;
}

}  // namespace

bool ReportOutcome::whole() const {
    return std::all_of(files.begin(), files.end(), [](const ReportFile& file) { return file.whole; });
}

Result<ReportOutcome> writeReport(const fs::path& mission, const fs::path& out, const ReportOptions& options,
                                  const Progress& progress) {
    const auto started = std::chrono::steady_clock::now();
    auto opened = ReportSource::open(mission, part(progress, 0.0, 0.4));
    if (!opened) return opened.error();
    ReportSource source = std::move(opened).value();
    ReportModel model = reportOf(source.input(), part(progress, 0.4, 0.6));
    if (progress.cancelled())
        return Error{
            leitstand::fill(translate("leitstand::Error", "{}: the report was cancelled"), mission.string())};
    std::error_code problem;
    fs::create_directories(out, problem);
    if (problem)
        return Error{leitstand::fill(translate("leitstand::Error", "{}: cannot be made: {}"), out.string(),
                                     problem.message())};

    ReportOutcome outcome;
    outcome.warnings = source.warnings();
    warnOfMissing(model, source.mentionsMap(), outcome.warnings);
    outcome.name = handInName(model.facts);
    outcome.finds = model.finds.size();
    const FindList victims = listOf(model, FindList::Kind::Victims);
    outcome.victims = victims.finds.size();
    outcome.scans = model.scans;
    outcome.explored = model.explored;
    const EarlierReport earlier(out);
    Writing writing(out, outcome.name, progress);
    writeMaps(writing, model);
    writeLists(writing, model);
    writeSearch(writing, model);
    writeClouds(writing, model, source.input());
    progress.done(0.8);
    if (options.pdf && !progress.cancelled()) {
        const ReportContent content =
            contentOf(std::move(model), source, options, outcome.warnings, progress);
        writing.file(".pdf", [&](const fs::path& file) -> Written {
            const auto bytes = options.pdf(content);
            if (!bytes) return {bytes.error()};
            // A cover, each map, and each find.
            return {detail::writeWhole(file, *bytes),
                    {.count = 1 + content.maps.size() + content.finds.size()}};
        });
    }
    // Only when all of the new report is there, and before it is listed: the list of the old files would be
    // lost.
    std::vector<std::string> listed = writing.names();
    if (writing.failure() && !progress.cancelled()) {
        for (std::string& old : earlier.untouched(listed)) listed.push_back(std::move(old));
    } else if (!progress.cancelled()) {
        const auto problems = earlier.remove(outcome.name, listed, victims);
        outcome.warnings.insert(outcome.warnings.end(), problems.begin(), problems.end());
    }
    writing.file("SHA256SUMS", [&](const fs::path&) -> Written {
        return {writeChecksums(out, listed), {.count = listed.size()}};
    });
    if (writing.failure()) return *writing.failure();
    progress.done(0.9);
    outcome.files = checked(writing, progress);
    outcome.seconds = toSeconds(std::chrono::steady_clock::now() - started);
    return outcome;
}

}  // namespace leitstand
