#include "app/cli/load_scans.h"

#include <cstdio>
#include <memory>

#include <fmt/format.h>

#include "core/io/scan_source.h"

namespace leitstand::cli {

void complain(ProgressLine& line, const std::string& text) {
    line.clear();
    fmt::print(stderr, "leitstandctl: {}\n", text);
}

std::vector<LoadedScan> loadScans(const std::vector<std::filesystem::path>& files,
                                  const std::stop_token& stop, ProgressLine& line, int& broken) {
    std::vector<LoadedScan> scans;
    for (std::size_t i = 0; i < files.size() && !stop.stop_requested(); ++i) {
        line.show("reading " + files[i].filename().string(), double(i) / double(files.size()));
        auto reading = readScan(files[i]);
        if (!reading) {
            complain(line, reading.error().text);
            ++broken;
            continue;
        }
        for (const std::string& warning : reading->warnings) complain(line, warning);
        scans.push_back({std::make_shared<const Scan>(std::move(reading).value().scan), i});
    }
    return scans;
}

}  // namespace leitstand::cli
