#include "tests/support/others_tools.h"

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

ProcessOutcome readByOctomap(const fs::path& tree) {
    return readBy("/usr/bin/bt2vrml", "octomap-tools", {tree.string()});
}

ProcessOutcome readByPoppler(const fs::path& pages) {
    return readBy("/usr/bin/pdftotext", "poppler-utils", {"-layout", pages.string(), "-"});
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
