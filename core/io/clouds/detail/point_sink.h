#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand::detail {

/// Largest coordinate of a point [m]. Float32 still resolves 8 mm there; real scans do not reach that far.
inline constexpr double MaxCoordinate = 100'000.0;

/// Returns the point that stands for "no echo".
[[nodiscard]] Eigen::Vector3f noEcho();

/// Fills a scan with the values that a reader finds. A function that refuses a value returns what was
/// expected; it returns nothing when it took the value.
class PointSink {
public:
    explicit PointSink(Scan& scan) : m_scan(scan) {}

    /// Reserves all memory at once. A vector that grows would for a moment need the memory twice.
    void reserve(std::size_t points, bool intensities, bool labels);
    /// Appends a point [m]. If any coordinate is NaN, all become NaN. Refuses coordinates beyond
    /// MaxCoordinate.
    [[nodiscard]] std::optional<std::string_view> addPoint(double x, double y, double z);
    /// Appends the intensity of the last point. A point without echo need not have one.
    [[nodiscard]] std::optional<std::string_view> addIntensity(double value);
    /// Appends the label of the last point. A value that is no number of Label is remembered as foreign.
    void addLabel(double value);
    /// Drops all labels if some are foreign, and adds a warning about @p file to @p warnings.
    void finish(const std::string& file, std::vector<std::string>& warnings);

private:
    Scan& m_scan;
    bool m_foreignLabels = false;
};

}  // namespace leitstand::detail
