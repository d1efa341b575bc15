#include "tests/support/others_tools.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <vector>

#include "tests/support/places.h"

namespace leitstand::test {
namespace {

namespace fs = std::filesystem;

ProcessOutcome readBy(const fs::path& program, const std::string& package,
                      const std::vector<std::string>& arguments) {
    std::error_code ignored;
    if (!fs::exists(program, ignored))
        return {NotInstalled, "", program.string() + " is not installed (Debian package " + package + ")"};
    return runProcess(program, arguments);
}

}  // namespace

ProcessOutcome readByGdal(const fs::path& map) {
    return readBy("/usr/bin/gdalinfo", "gdal-bin", {map.string()});
}

ProcessOutcome colourByGdal(const fs::path& map, double x, double y) {
    // Of a picture of our map east is -y and north is x.
    ProcessOutcome read =
        readBy("/usr/bin/gdallocationinfo", "gdal-bin",
               {"-valonly", "-geoloc", map.string(), std::to_string(-y), std::to_string(x)});
    while (read.out.ends_with('\n')) read.out.pop_back();
    std::replace(read.out.begin(), read.out.end(), '\n', ' ');
    return read;
}

ProcessOutcome readByPython(const std::string& script, const fs::path& file) {
    return readBy("/usr/bin/python3", "python3", {"-c", script, file.string()});
}

ProcessOutcome askBySqlite(const fs::path& log, const std::string& query) {
    return readBy("/usr/bin/sqlite3", "sqlite3", {log.string(), query});
}

ProcessOutcome readByOctomap(const fs::path& tree) {
    return readBy("/usr/bin/bt2vrml", "octomap-tools", {tree.string()});
}

ProcessOutcome readByPoppler(const fs::path& pages) {
    return readBy("/usr/bin/pdftotext", "poppler-utils", {"-layout", pages.string(), "-"});
}

ProcessOutcome boxesByPoppler(const fs::path& pages) {
    return readBy("/usr/bin/pdftotext", "poppler-utils", {"-bbox", pages.string(), "-"});
}

ProcessOutcome readByPcl(const fs::path& ply, const fs::path& pcd) {
    return readBy("/usr/bin/pcl_ply2pcd", "pcl-tools", {ply.string(), pcd.string()});
}

ProcessOutcome readByNpm(const fs::path& mission) {
    const fs::path tests = fs::path(sourceFolder()) / "tests";
    fs::path log;
    for (const auto& entry : fs::directory_iterator(mission)) {
        if (entry.path().extension() == ".db3") log = entry.path();
    }
    return runProcess(tests / "npm" / "run", {(tests / "bag_peer" / "read_bag.js").string(), log.string(),
                                              (mission / "metadata.yaml").string()});
}

}  // namespace leitstand::test
