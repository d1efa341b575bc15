#include "tests/architecture/include_rules.h"

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>

namespace leitstand::test {
namespace {

struct Rule {
    std::string_view folder;                ///< longest matching folder decides
    std::vector<std::string_view> project;  ///< folders of ours that may be included
    std::vector<std::string_view> foreign;  ///< libraries that may be included
};

const std::vector<Rule>& rules() {
    static const std::vector<std::string_view> coreLibraries = {"Eigen", "tbb",  "fmt",  "opencv",
                                                                "zbar",  "zlib", "libav"};
    static const std::vector<std::string_view> core = {
        "core/base",       "core/cloud",   "core/event",   "core/registration", "core/robot",
        "core/perception", "core/mapping", "core/mission", "core/station",      "core/handin",
        "core/settings",   "core/version", "core/messages"};
    static const auto with = [](std::vector<std::string_view> list, std::vector<std::string_view> more) {
        list.insert(list.end(), more.begin(), more.end());
        return list;
    };
    static const std::vector<Rule> all = {
        {"core", core, coreLibraries},
        {"core/io",
         with(core, {"core/io"}),
         {"Eigen", "fmt", "bzip2", "libdeflate", "lz4", "lzf", "sqlite3", "yaml-cpp", "nlohmann", "zlib",
          "zstd"}},
        {"core/io/handin",
         with(core, {"core/io"}),
         {"Eigen", "fmt", "gdal", "octomap", "openssl", "yaml-cpp"}},
        {"core/io/model", with(core, {"core/io"}), {"Eigen", "fmt", "assimp", "tinyxml2"}},
        {"transport", with(core, {"transport"}), {"Eigen", "fmt", "fastdds", "openssl"}},
        {"robots",
         with(core, {"core/io", "transport", "robots/hardware", "robots/kurt3d", "robots/crawler",
                     "robots/control", "robots/agent", "robots/wire"}),
         {"Eigen", "fmt", "yaml-cpp", "libav"}},
        {"robots/simulation",
         with(core, {"core/io", "transport", "robots"}),
         {"Eigen", "fmt", "embree", "CLI", "yaml-cpp", "opencv", "qrencode"}},
        {"widgets/models", with(core, {"widgets/models"}), {"Eigen", "fmt", "Qt"}},
        {"widgets", with(core, {"widgets"}), {"Eigen", "fmt", "Qt", "vtk", "EGL"}},
        {"app/services", with(core, {"core/io", "transport", "app/services"}), {"Eigen", "fmt"}},
        {"app/report", with(core, {"app/services/handin", "app/report"}), {"Eigen", "fmt", "Qt"}},
        {"app/language", {"core/base", "app/language"}, {"Qt"}},
        {"app/guard", with(core, {"transport"}), {}},
        {"app/options", with(core, {"app/options"}), {"fmt", "CLI"}},
        {"app/cli",
         with(core, {"core/io", "transport", "app/options", "app/services", "app/report", "app/language",
                     "app/cli"}),
         {"Eigen", "fmt", "CLI", "nlohmann", "Qt"}},
        {"app/window",
         with(core, {"app/options", "app/services", "app/report", "app/language", "widgets", "app/window"}),
         {"Eigen", "fmt", "CLI", "Qt", "SDL"}},
    };
    return all;
}

/// Rooms of a folder, the lowest first; includes go down the list only, so that no circle can come.
struct Order {
    std::string_view folder;
    std::ptrdiff_t depth;  ///< of its rooms' paths
    std::vector<std::string_view> rooms;
};

const std::vector<Order>& orders() {
    static const std::vector<Order> all = {
        {"core",
         2,
         {"core/base", "core/version", "core/messages", "core/cloud", "core/event", "core/registration",
          "core/robot", "core/perception", "core/mapping", "core/mission", "core/station", "core/handin",
          "core/settings", "core/io"}},
        {"widgets",
         3,
         {"widgets/models",
          "widgets/models/live",
          "widgets/models/map",
          "widgets/models/pad",
          "widgets/models/review",
          "widgets/models/victims",
          "widgets/models/camera",
          "widgets/models/changes",
          "widgets/models/coverage",
          "widgets/models/joints",
          "widgets/models/score",
          "widgets/models/timeline",
          "widgets/models/topics",
          "widgets/models/frames",
          "widgets/painting",
          "widgets/tables",
          "widgets/alarms",
          "widgets/camera",
          "widgets/changes",
          "widgets/coverage",
          "widgets/drive",
          "widgets/joints",
          "widgets/link",
          "widgets/map_decisions",
          "widgets/messages",
          "widgets/mission",
          "widgets/pad",
          "widgets/preflight",
          "widgets/review",
          "widgets/robots",
          "widgets/scans",
          "widgets/score",
          "widgets/timeline",
          "widgets/topics",
          "widgets/frames",
          "widgets/readings",
          "widgets/victims",
          "widgets/virtual_scan",
          "widgets/map_view/camera",
          "widgets/map_view/scene",
          "widgets/map_view/render",
          "widgets/map_view/overlays",
          "widgets/map_view/robots",
          "widgets/map_view/victims",
          "widgets/map_view/gestures",
          "widgets/map_view"}},
        {"app",
         3,
         {"app/language",
          "app/guard",
          "app/options",
          "app/services",
          "app/services/domain",
          "app/services/topics",
          "app/services/layouts",
          "app/services/pad",
          "app/services/score",
          "app/services/places",
          "app/services/log",
          "app/services/offline",
          "app/services/mapping",
          "app/services/models",
          "app/services/team",
          "app/services/victims",
          "app/services/finds",
          "app/services/recorded",
          "app/services/thinning",
          "app/services/coverage",
          "app/services/comparison",
          "app/services/review",
          "app/services/handin",
          "app/services/station",
          "app/services/by_hand",
          "app/services/preflight",
          "app/report",
          "app/report/pdf",
          "app/cli/console",
          "app/cli/options",
          "app/cli",
          "app/window/commands",
          "app/window/shell",
          "app/window/source",
          "app/window/map",
          "app/window/frame",
          "app/window/input",
          "app/window/panes",
          "app/window/scans",
          "app/window/robots",
          "app/window/layouts",
          "app/window/live",
          "app/window/review",
          "app/window"}},
    };
    return all;
}

bool inFolder(std::string_view path, std::string_view folder) {
    return path.size() > folder.size() && path.starts_with(folder) && path[folder.size()] == '/';
}

const Rule* ruleOf(std::string_view path) {
    const Rule* best = nullptr;
    for (const Rule& rule : rules()) {
        if (inFolder(path, rule.folder) && (best == nullptr || rule.folder.size() > best->folder.size())) {
            best = &rule;
        }
    }
    return best;
}

const Order* orderOf(std::string_view path) {
    for (const Order& order : orders()) {
        if (inFolder(path, order.folder)) return &order;
    }
    return nullptr;
}

/// Where the room of @p path stands in @p order; its size when it is none of the rooms.
std::size_t rankOf(std::string_view path, const Order& order) {
    std::ptrdiff_t slashes = 0;
    std::size_t end = 0;
    for (std::size_t i = 0; i < path.size() && slashes < order.depth; ++i) {
        if (path[i] != '/') continue;
        ++slashes;
        end = i;
    }
    const auto room = std::find(order.rooms.begin(), order.rooms.end(), path.substr(0, end));
    return static_cast<std::size_t>(room - order.rooms.begin());
}

/// The header between quotes or angle brackets of an #include line.
std::optional<std::string_view> includedHeader(std::string_view line) {
    const auto skipBlanks = [&line] {
        while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    };
    skipBlanks();
    if (!line.starts_with('#')) return std::nullopt;
    line.remove_prefix(1);
    skipBlanks();
    if (!line.starts_with("include")) return std::nullopt;
    const auto begin = line.find_first_of("\"<");
    const auto end = line.find_last_of("\">");
    if (begin == std::string_view::npos || end <= begin) return std::nullopt;
    return line.substr(begin + 1, end - begin - 1);
}

bool isProject(std::string_view header) {
    for (const std::string_view top :
         {"core/", "transport/", "robots/", "widgets/", "app/", "tests/", "fuzz/"}) {
        if (header.starts_with(top)) return true;
    }
    return false;
}

/// The library a header belongs to; empty for the standard library, the C library and the compiler.
std::string_view libraryOf(std::string_view header) {
    static const std::vector<std::pair<std::string_view, std::string_view>> prefixes = {
        {"Eigen/", "Eigen"},
        {"tbb/", "tbb"},
        {"oneapi/", "tbb"},
        {"fmt/", "fmt"},
        {"pcl/", "pcl"},
        {"opencv2/", "opencv"},
        {"zbar", "zbar"},
        {"libav", "libav"},
        {"libsw", "libav"},
        {"zlib.h", "zlib"},
        {"vtk", "vtk"},
        {"EGL/", "EGL"},
        {"CLI/", "CLI"},
        {"nlohmann/", "nlohmann"},
        {"gdal", "gdal"},
        {"ogr_", "gdal"},
        {"cpl_", "gdal"},
        {"octomap/", "octomap"},
        {"assimp/", "assimp"},
        {"tinyxml2.h", "tinyxml2"},
        {"sqlite3", "sqlite3"},
        {"yaml-cpp/", "yaml-cpp"},
        {"fastdds/", "fastdds"},
        {"fastrtps/", "fastdds"},
        {"openssl/", "openssl"},
        {"qrencode", "qrencode"},
        {"embree3/", "embree"},
        {"embree4/", "embree"},
        {"SDL2/", "SDL"},
        {"Qt", "Qt"},
        {"boost/", "boost"},
        {"rclcpp/", "ROS"},
        {"lzf.h", "lzf"},
        {"lz4", "lz4"},
        {"zstd.h", "zstd"},
        {"bzlib.h", "bzip2"},
        {"libdeflate.h", "libdeflate"},
    };
    for (const auto& [prefix, library] : prefixes) {
        if (header.starts_with(prefix)) return library;
    }
    if (header.size() > 1 && header[0] == 'Q' && std::isupper(static_cast<unsigned char>(header[1])) != 0) {
        return "Qt";
    }
    return {};
}

}  // namespace

std::vector<std::string> includeViolations(std::string_view path, std::string_view text) {
    const Rule* rule = ruleOf(path);
    if (rule == nullptr) return {fmt::format("{}: stands in no folder of design section 2", path)};
    const Order* const order = orderOf(path);
    const std::size_t rank = order == nullptr ? 0 : rankOf(path, *order);
    if (order != nullptr && rank == order->rooms.size())
        return {fmt::format("{}: stands in no room of the order of {}", path, order->folder)};
    std::vector<std::string> found;
    std::size_t number = 0;
    while (!text.empty()) {
        const auto end = std::min(text.find('\n'), text.size());
        const auto header = includedHeader(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        ++number;
        if (!header) continue;
        if (isProject(*header)) {
            const bool allowed =
                std::any_of(rule->project.begin(), rule->project.end(),
                            [&](std::string_view folder) { return inFolder(*header, folder); });
            if (!allowed)
                found.push_back(
                    fmt::format("{}:{}: {} may not include {}", path, number, rule->folder, *header));
            if (order != nullptr && inFolder(*header, order->folder) && rankOf(*header, *order) > rank)
                found.push_back(fmt::format("{}:{}: {} stands above {}, which may not include {}", path,
                                            number, *header, order->rooms[rank], *header));
            continue;
        }
        const std::string_view library = libraryOf(*header);
        if (library.empty()) continue;
        if (std::find(rule->foreign.begin(), rule->foreign.end(), library) == rule->foreign.end()) {
            found.push_back(
                fmt::format("{}:{}: {} may not use {} ({})", path, number, rule->folder, library, *header));
        }
    }
    return found;
}

}  // namespace leitstand::test
