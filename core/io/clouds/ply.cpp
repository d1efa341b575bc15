#include "core/io/clouds/ply.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/io/clouds/detail/cloud_decoder.h"
#include "core/io/clouds/detail/cloud_encoder.h"
#include "core/io/clouds/detail/ply_header.h"
#include "core/io/clouds/detail/scan_grid.h"
#include "core/io/detail/output_file.h"

namespace leitstand {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t FlushSize = 1 << 18;

Result<void> readBody(detail::CloudDecoder& decoder, detail::LineReader& reader, const fs::path& path,
                      const detail::PlyHeader& header) {
    if (header.text) {
        std::string_view line;
        for (std::size_t i = 0; i < header.linesBefore && reader.next(line); ++i) {
        }
        return decoder.readLines(reader, header.points);
    }
    auto opened = detail::InputFile::open(path);
    if (!opened) return opened.error();
    detail::InputFile file = std::move(opened).value();
    return decoder.readRecords(file, header.verticesAt, header.points, header.order);
}

std::string headerOf(const Scan& scan, PlyEncoding encoding) {
    std::string header =
        fmt::format("ply\nformat {} 1.0\ncomment points in metres, x forward, y left, z up\n",
                    encoding == PlyEncoding::Ascii ? "ascii" : "binary_little_endian");
    if (scan.organised()) {
        header += fmt::format("obj_info num_cols {}\nobj_info num_rows {}\n", scan.columns, scan.rows);
    }
    header += fmt::format("element vertex {}\nproperty float x\nproperty float y\nproperty float z\n",
                          scan.points.size());
    if (!scan.intensities.empty()) header += "property float intensity\n";
    if (!scan.labels.empty())
        header += "comment label: 0 none, 1 floor, 2 wall, 3 ceiling\nproperty uchar label\n";
    return header + "end_header\n";
}

}  // namespace

Result<ScanReading> readPly(const fs::path& path) {
    auto opened = detail::LineReader::open(path);
    if (!opened) return opened.error();
    detail::LineReader reader = std::move(opened).value();
    const auto header = detail::readPlyHeader(reader);
    if (!header) return header.error();

    ScanReading reading;
    Scan& scan = reading.scan;
    scan.name = path.stem().string();
    scan.rows = header->rows;
    scan.columns = header->columns;
    detail::CloudDecoder decoder(header->layout, scan);
    if (auto body = readBody(decoder, reader, path, *header); !body) return body.error();
    decoder.finish(path.string(), reading.warnings);
    detail::organise(scan);
    return reading;
}

Result<void> writePly(const fs::path& file, const Scan& scan, PlyEncoding encoding) {
    auto created = detail::OutputFile::create(file);
    if (!created) return created.error();
    detail::OutputFile out = std::move(created).value();
    out.write(headerOf(scan, encoding));
    std::string chunk;
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
        if (encoding == PlyEncoding::Ascii) {
            detail::appendLine(chunk, scan, i);
        } else {
            detail::appendRecord(chunk, scan, i, 1);
        }
        if (chunk.size() < FlushSize && i + 1 < scan.points.size()) continue;
        out.write(chunk);
        chunk.clear();
    }
    return out.commit();
}

}  // namespace leitstand
