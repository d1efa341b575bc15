#include "core/io/clouds/cloud_writer.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/io/clouds/cloud_formats.h"
#include "core/io/clouds/detail/uos_names.h"
#include "core/io/clouds/uos.h"
#include "core/io/detail/unfinished.h"

namespace leitstand {

namespace fs = std::filesystem;

namespace {

void append(Scan& merged, const PlacedScan& placed, const CloudRange& range, bool intensities) {
    const Scan& scan = *placed.scan;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        const Eigen::Vector3f& point = scan.points[i];
        const auto distance = static_cast<double>(point.norm());
        if (!(distance >= range.min && distance <= range.max) || !point.allFinite()) continue;
        merged.points.emplace_back((placed.poseInMap * point.cast<double>()).cast<float>());
        merged.labels.push_back(scan.labels.empty() ? Label::Unlabelled : scan.labels[i]);
        if (intensities) merged.intensities.push_back(scan.intensities[i]);
    }
}

Scan mergedCloud(const std::vector<PlacedScan>& scans, const CloudRange& range) {
    const bool intensities = std::all_of(scans.begin(), scans.end(), [](const PlacedScan& placed) {
        return !placed.scan->intensities.empty();
    });
    std::size_t most = 0;
    for (const PlacedScan& placed : scans) most += placed.scan->points.size();
    Scan merged;
    merged.points.reserve(most);
    merged.labels.reserve(most);
    if (intensities) merged.intensities.reserve(most);
    for (const PlacedScan& placed : scans) append(merged, placed, range, intensities);
    return merged;
}

/// Creates @p folder and checks that @p scans scans may be written there. Scans of a former map, which have a
/// .frames, may be overwritten; those of a robot may not.
Result<void> prepareFolder(const fs::path& folder, std::size_t scans) {
    std::error_code problem;
    fs::create_directories(folder, problem);
    if (problem) return Error{fmt::format("{}: cannot be created: {}", folder.string(), problem.message())};
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end;
         entry.increment(problem)) {
        const auto number = detail::uosNumber(entry->path());
        if (!number) continue;
        const bool ofAMap = fs::exists(fs::path(entry->path()).replace_extension(".frames"));
        if (*number < scans && ofAMap) continue;
        return Error{
            fmt::format("{}: is in the way: expected a folder without other scans", entry->path().string())};
    }
    if (problem) return Error{fmt::format("{}: cannot be read: {}", folder.string(), problem.message())};
    return {};
}

Result<void> writeFolder(const fs::path& folder, const std::vector<PlacedScan>& scans) {
    detail::Unfinished unfinished(folder);
    if (auto prepared = prepareFolder(folder, scans.size()); !prepared) return prepared;
    for (std::size_t i = 0; i < scans.size(); ++i) {
        const std::string base = (folder / detail::uosName(i)).string();
        const Pose& pose = scans[i].poseInMap;
        for (const char* ending : {".frames", ".pose", ".3d"}) unfinished.file(base + ending);
        if (auto done = writeUosFrames(base + ".frames", {{pose}}); !done) return done;
        if (auto done = writeUosPose(base + ".pose", pose); !done) return done;
        if (auto done = writeUosPoints(base + ".3d", *scans[i].scan); !done) return done;
    }
    unfinished.done();
    return {};
}

Result<void> writeMerged(const fs::path& out, const std::vector<PlacedScan>& scans, const CloudRange& range) {
    const CloudFormat* const format = cloudFormatOf(out);
    if (format == nullptr || format->write == nullptr) {
        return Error{fmt::format("{}: expected an ending {}, or a folder that ends in /", out.string(),
                                 listOf(CloudEndings::Written, ", ", " or "))};
    }
    const Scan merged = mergedCloud(scans, range);
    if (merged.points.empty()) return Error{out.string() + ": is not written: no point is in range"};
    return format->write(out, merged);
}

}  // namespace

Result<void> writeMapCloud(const fs::path& out, const std::vector<PlacedScan>& scans,
                           const CloudRange& range) {
    if (scans.empty()) return Error{out.string() + ": is not written: the map is empty"};
    std::error_code ignored;
    if (!out.has_filename() || fs::is_directory(out, ignored)) return writeFolder(out, scans);
    return writeMerged(out, scans, range);
}

}  // namespace leitstand
