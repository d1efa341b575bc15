#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/cloud/scan.h"

namespace leitstand::detail {

/// Largest coordinate of a point [m]. There, float32 still resolves 8 mm. Real scans end well below.
inline constexpr double MaxCoordinate = 100'000.0;

/// Returns the point that stands for "no echo".
[[nodiscard]] Eigen::Vector3f noEcho();

/// Fills a scan with what a reader finds. A function that refuses a value returns what was expected instead;
/// empty: it took the value.
class PointSink {
public:
    explicit PointSink(Scan& scan) : m_scan(scan) {}

    /// Reserves memory at once, since a growing vector would hold everything twice.
    void reserve(std::size_t points, bool intensities, bool labels);
    /// Appends a point [m], all NaN when any coordinate is NaN. Refuses coordinates beyond MaxCoordinate.
    [[nodiscard]] std::optional<std::string_view> addPoint(double x, double y, double z);
    /// Appends the intensity of the last point; a point without echo may lack it.
    [[nodiscard]] std::optional<std::string_view> addIntensity(double value);
    /// Appends the label of the last point, a number of Label. Other numbers are noted as foreign.
    void addLabel(double value);
    /// If some labels are foreign, drops all labels and adds a warning about @p file to @p warnings.
    void finish(const std::string& file, std::vector<std::string>& warnings);

private:
    Scan& m_scan;
    bool m_foreignLabels = false;
};

}  // namespace leitstand::detail
