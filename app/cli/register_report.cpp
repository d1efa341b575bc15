#include "app/cli/register_report.h"

#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/console/output.h"
#include "app/cli/console/text_table.h"

namespace leitstand::cli {

namespace {

nlohmann::ordered_json placesJson(const std::vector<SamePlace>& places) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const SamePlace& one : places)
        json.push_back({{"from", one.from}, {"to", one.to}, {"shift", one.shift}});
    return json;
}

std::string loopsText(const Map& map, const ClosedMap& loops) {
    std::string text;
    const auto addLine = [&](const SamePlace& one, const char* what) {
        text += fmt::format("{} and {} (scans {} and {}): {:.2f} m off, {}\n", map.scans[one.from].scan->name,
                            map.scans[one.to].scan->name, one.from, one.to, one.shift, what);
    };
    for (const SamePlace& one : loops.closed) addLine(one, "closed");
    for (const SamePlace& one : loops.contradicted) addLine(one, "LEFT OUT: the rest speaks against it");
    for (const SamePlace& one : loops.unsure)
        addLine(one, "NOT CLOSED: farther than expected; say by --by-hand whether it is the same place");
    if (loops.unused > 0)
        text += fmt::format("{} links by hand are of scans with too few points\n", loops.unused);
    const Relaxation& relaxed = loops.relaxation;
    return text + fmt::format(
                      "{} loops closed; {} of {} scans fit what lies about them, pairs {:.1f} mm apart "
                      "before, {:.1f} mm after {} rounds{}; scans moved by up to {:.3f} m\n",
                      loops.closed.size(), relaxed.matched, map.scans.size(), 1e3 * relaxed.rmsBefore,
                      1e3 * relaxed.rmsAfter, relaxed.rounds, relaxed.settled ? "" : ", not settled",
                      relaxed.largest);
}

}  // namespace

std::string registerJson(const Map& map, const ClosedMap* loops, double seconds) {
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
    nlohmann::ordered_json json = {{"scans", scans}, {"seconds", seconds}};
    if (loops != nullptr) {
        json["loops"] = {
            {"closed", placesJson(loops->closed)},        {"contradicted", placesJson(loops->contradicted)},
            {"unsure", placesJson(loops->unsure)},        {"matched", loops->relaxation.matched},
            {"rounds", loops->relaxation.rounds},         {"settled", loops->relaxation.settled},
            {"largest_shift", loops->relaxation.largest}, {"rms_before", loops->relaxation.rmsBefore},
            {"rms_after", loops->relaxation.rmsAfter}};
    }
    return jsonText(json);
}

std::string registerTable(const Map& map, const ClosedMap* loops, double seconds) {
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
    return textTable(rows) + (loops != nullptr ? loopsText(map, *loops) : std::string()) +
           fmt::format("{} scans in {:.2f} s\n", map.scans.size(), seconds);
}

}  // namespace leitstand::cli
