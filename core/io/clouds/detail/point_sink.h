#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand::detail {

/// Scans end well before this, and float32 still resolves 8 mm there [m].
inline constexpr double MaxCoordinate = 100'000.0;

/// The point that stands for "no echo".
[[nodiscard]] Eigen::Vector3f noEcho();

/// Fills a scan with what a reader finds; every member says, when it refuses, what was expected instead.
class PointSink {
public:
    explicit PointSink(Scan& scan) : m_scan(scan) {}

    /// Makes room at once: a vector that grows would hold everything twice.
    void reserve(std::size_t points, bool intensities, bool labels);
    /// Appends a point [m], all NaN when any coordinate is; refuses infinite and absurd ones.
    [[nodiscard]] std::optional<std::string_view> addPoint(double x, double y, double z);
    /// Appends the intensity of the last point; one without echo may lack it.
    [[nodiscard]] std::optional<std::string_view> addIntensity(double value);
    /// Appends the label of the last point: a number of Label. Others are remembered as foreign.
    void addLabel(double value);
    /// Drops labels that were not ours, which @p warnings then says of @p file.
    void finish(const std::string& file, std::vector<std::string>& warnings);

private:
    Scan& m_scan;
    bool m_foreignLabels = false;
};

}  // namespace leitstand::detail
