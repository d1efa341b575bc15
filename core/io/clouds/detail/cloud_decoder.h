#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/cloud/scan.h"
#include "core/io/clouds/detail/cloud_layout.h"
#include "core/io/clouds/detail/point_sink.h"
#include "core/io/detail/input_file.h"
#include "core/io/detail/line_reader.h"

namespace leitstand::detail {

enum class ByteOrder : bool { Little, Big };

/// Decodes the body of a PCD or PLY file into a scan.
class CloudDecoder {
public:
    /// @p layout must have points.
    CloudDecoder(const CloudLayout& layout, Scan& into);

    /// Reads @p points records in chunks, from byte @p offset of @p file on. Error when the file has fewer
    /// records.
    [[nodiscard]] Result<void> readRecords(InputFile& file, std::uint64_t offset, std::size_t points,
                                           ByteOrder order);
    /// Takes @p points points from @p columns: one array per field, in the order of the layout (compressed
    /// PCD).
    [[nodiscard]] Result<void> takeColumns(const std::vector<char>& columns, std::size_t points,
                                           const std::string& file);
    /// Reads @p points lines with one point each. Error when there are fewer lines.
    [[nodiscard]] Result<void> readLines(LineReader& reader, std::size_t points);

    /// Drops all labels if some are not numbers of Label, and adds a warning about @p file to @p warnings.
    void finish(const std::string& file, std::vector<std::string>& warnings);

private:
    static constexpr std::size_t Roles = 5;  // x, y, z, intensity, label
    using Values = std::array<double, Roles>;

    [[nodiscard]] std::optional<std::string_view> keep(const Values& values);
    [[nodiscard]] std::optional<std::string> takeLine(std::string_view line);
    void reserve(std::size_t points);

    const CloudLayout& m_layout;
    PointSink m_sink;
    std::array<const CloudField*, Roles> m_fields;  // null: not in the file
};

}  // namespace leitstand::detail
