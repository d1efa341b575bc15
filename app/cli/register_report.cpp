#include "app/cli/register_report.h"

#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/console/output.h"
#include "app/cli/console/text_table.h"

namespace leitstand::cli {

std::string registerJson(const Map& map, double seconds) {
    nlohmann::ordered_json scans = nlohmann::ordered_json::array();
    for (const MapScan& scan : map.scans) {
        std::vector<double> pose;
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) pose.push_back(scan.poseInMap.matrix()(row, column));
        }
        scans.push_back({{"name", scan.scan->name},
                         {"points", scan.scan->points.size()},
                         {"points_used", scan.pointsUsed},
                         {"iterations", scan.icp.iterations},
                         {"seconds", scan.seconds},
                         {"rms", scan.icp.rms},
                         {"inlier_ratio", scan.icp.inlierRatio},
                         {"overlap", scan.icp.overlap},
                         {"certainty", scan.icp.certainty},
                         {"converged", !scan.registered || scan.icp.converged},
                         {"pose", pose}});
    }
    return jsonText({{"scans", scans}, {"seconds", seconds}});
}

std::string registerTable(const Map& map, double seconds) {
    std::vector<std::vector<std::string>> rows = {{"scan", "points", "used", "iterations", "time", "rms",
                                                   "inliers", "overlap", "certainty", "x", "y", "z", "turn",
                                                   ""}};
    for (const MapScan& scan : map.scans) {
        const Eigen::Vector3d position = scan.poseInMap.translation();
        std::vector<std::string> row = {scan.scan->name, fmt::format("{}", scan.scan->points.size()),
                                        fmt::format("{}", scan.pointsUsed)};
        if (scan.registered) {
            row.insert(row.end(),
                       {fmt::format("{}", scan.icp.iterations), fmt::format("{:.0f} ms", 1e3 * scan.seconds),
                        fmt::format("{:.1f} mm", 1e3 * scan.icp.rms),
                        fmt::format("{:.0f} %", 100.0 * scan.icp.inlierRatio),
                        fmt::format("{:.0f} %", 100.0 * scan.icp.overlap),
                        fmt::format("{:.3f}", scan.icp.certainty)});
        } else {
            row.insert(row.end(), {"", fmt::format("{:.0f} ms", 1e3 * scan.seconds), "", "", "", ""});
        }
        row.insert(row.end(),
                   {fmt::format("{:.3f} m", position.x()), fmt::format("{:.3f} m", position.y()),
                    fmt::format("{:.3f} m", position.z()),
                    fmt::format("{:.2f}°", inDegrees(angleBetween(Pose::Identity(), scan.poseInMap))),
                    !scan.registered      ? "reference"
                    : !scan.icp.converged ? "NOT CONVERGED"
                                          : ""});
        rows.push_back(row);
    }
    return textTable(rows) + fmt::format("{} scans in {:.2f} s\n", map.scans.size(), seconds);
}

}  // namespace leitstand::cli
