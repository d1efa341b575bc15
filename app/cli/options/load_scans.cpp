#include "app/cli/options/load_scans.h"

#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "app/cli/console/output.h"
#include "app/services/offline/mission_scans.h"
#include "core/io/clouds/scan_source.h"

namespace leitstand::cli {

void complain(ProgressLine& line, const std::string& text) {
    line.clear();
    printError(text);
}

namespace {

void loadFile(const std::filesystem::path& file, LoadedScans& loaded, ProgressLine& line) {
    const std::size_t position = loaded.expected++;
    auto reading = readScan(file);
    if (!reading) {
        complain(line, reading.error().text);
        ++loaded.broken;
        return;
    }
    for (const std::string& warning : reading->warnings) complain(line, warning);
    loaded.scans.push_back({std::make_shared<const Scan>(std::move(reading).value().scan), position});
}

void loadMission(const std::filesystem::path& mission, const std::stop_token& stop, LoadedScans& loaded,
                 ProgressLine& line) {
    const auto show = [&](double fraction) { line.show("reading " + mission.filename().string(), fraction); };
    const auto read = readMissionScans(mission, {show, stop});
    if (!read) {
        complain(line, read.error().text);
        ++loaded.broken;
        return;
    }
    for (const std::string& warning : read->warnings) complain(line, warning);
    for (const ScanPtr& scan : read->scans) loaded.scans.push_back({scan, loaded.expected++});
}

}  // namespace

Result<LoadedScans> loadScans(const std::vector<std::filesystem::path>& sources, const std::stop_token& stop,
                              ProgressLine& line) {
    LoadedScans loaded;
    for (const std::filesystem::path& source : sources) {
        if (isMission(source)) {
            loadMission(source, stop, loaded, line);
            continue;
        }
        const auto files = listScans({source});
        if (!files) return files.error();
        for (std::size_t i = 0; i < files->size() && !stop.stop_requested(); ++i) {
            line.show("reading " + (*files)[i].filename().string(), double(i) / double(files->size()));
            loadFile((*files)[i], loaded, line);
        }
    }
    return loaded;
}

}  // namespace leitstand::cli
