#include "fuzz/scan_checks.h"

#include "fuzz/input_file.h"

namespace leitstand::fuzz {

void checkReading(const Result<ScanReading>& read) {
    if (!read) {
        require(!read.error().text.empty(), "an error that tells something");
        return;
    }
    const Scan& scan = read->scan;
    const std::size_t points = scan.points.size();
    require(points > 0, "points");
    if (scan.organised()) {
        require(static_cast<std::size_t>(scan.rows) * static_cast<std::size_t>(scan.columns) == points,
                "as many points as the grid has places");
    }
    require(scan.intensities.empty() || scan.intensities.size() == points, "an intensity a point, or none");
    require(scan.labels.empty() || scan.labels.size() == points, "a label a point, or none");
    for (const Eigen::Vector3f& point : scan.points) {
        require(point.allFinite() || point.array().isNaN().all(), "points that are finite, or no echo");
    }
}

}  // namespace leitstand::fuzz
