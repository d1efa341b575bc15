#include "core/io/clouds/pcd.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <lzf.h>

#include "core/io/clouds/detail/cloud_encoder.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

namespace {

constexpr std::size_t LabelBytes = 4;  // as in pcl::PointXYZL
constexpr std::size_t FlushSize = 1 << 18;

std::string headerOf(const Scan& scan, PcdEncoding encoding) {
    const bool intensities = !scan.intensities.empty(), labels = !scan.labels.empty();
    const auto row = [&](const char* coordinates, const char* intensity, const char* label) {
        return std::string(coordinates) + (intensities ? intensity : "") + (labels ? label : "") + "\n";
    };
    const std::size_t width = scan.organised() ? static_cast<std::size_t>(scan.columns) : scan.points.size();
    const int height = scan.organised() ? scan.rows : 1;
    const char* data = encoding == PcdEncoding::Ascii    ? "ascii"
                       : encoding == PcdEncoding::Binary ? "binary"
                                                         : "binary_compressed";
    return "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n" +
           row("FIELDS x y z", " intensity", " label") + row("SIZE 4 4 4", " 4", " 4") +
           row("TYPE F F F", " F", " U") + row("COUNT 1 1 1", " 1", " 1") +
           fmt::format("WIDTH {}\nHEIGHT {}\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA {}\n", width, height,
                       scan.points.size(), data);
}

/// Returns the fields of all points, one field after another, as compressed PCD needs them.
std::vector<char> columnsOf(const Scan& scan) {
    const std::size_t points = scan.points.size();
    const std::size_t fields = 3U + (scan.intensities.empty() ? 0U : 1U) + (scan.labels.empty() ? 0U : 1U);
    std::vector<char> columns(points * fields * 4);
    char* to = columns.data();
    for (const Eigen::Index axis : {0, 1, 2}) {
        for (const Eigen::Vector3f& point : scan.points) {
            std::memcpy(to, &point[axis], 4);
            to += 4;
        }
    }
    if (!scan.intensities.empty()) {
        std::memcpy(to, scan.intensities.data(), points * 4);
        to += points * 4;
    }
    for (const Label label : scan.labels) {
        *to = static_cast<char>(label);
        to += LabelBytes;
    }
    return columns;
}

Result<void> writeCompressed(detail::OutputFile& out, const std::filesystem::path& file, const Scan& scan) {
    std::vector<char> columns = columnsOf(scan);
    constexpr std::size_t Most = std::size_t{1} << 31;
    if (columns.size() > Most)
        return Error{file.string() + ": cannot be written: more than 2 GB to compress"};
    const auto size = static_cast<std::uint32_t>(columns.size());
    std::vector<char> packed(columns.size() + columns.size() / 16 + 64);  // more than the worst case
    const std::uint32_t sizes[2] = {
        lzf_compress(columns.data(), size, packed.data(), static_cast<std::uint32_t>(packed.size())), size};
    if (sizes[0] == 0) return Error{file.string() + ": cannot be written: its points cannot be compressed"};
    out.write({reinterpret_cast<const char*>(sizes), sizeof(sizes)});
    out.write({packed.data(), sizes[0]});
    return {};
}

}  // namespace

Result<void> writePcd(const std::filesystem::path& file, const Scan& scan, PcdEncoding encoding) {
    auto created = detail::OutputFile::create(file);
    if (!created) return created.error();
    detail::OutputFile out = std::move(created).value();
    out.write(headerOf(scan, encoding));
    if (encoding == PcdEncoding::BinaryCompressed) {
        if (auto written = writeCompressed(out, file, scan); !written) return written;
        return out.commit();
    }
    std::string chunk;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (encoding == PcdEncoding::Ascii) {
            detail::appendLine(chunk, scan, i);
        } else {
            detail::appendRecord(chunk, scan, i, LabelBytes);
        }
        if (chunk.size() < FlushSize && i + 1 < scan.points.size()) continue;
        out.write(chunk);
        chunk.clear();
    }
    return out.commit();
}

}  // namespace leitstand
